#pragma once

#include <cmath>
#include <numbers>

// Exact volume of the part of a sphere that lies in an axis-parallel box.
//
//   C(a, b, c) = signed volume of the sphere within the box from its centre to the corner (a, b, c)
//              = a b c                                           if the corner lies inside the sphere
//              = +- (pi R^3/6 - q(a) - q(b) - q(c) + q(a, b) + q(b, c) + q(c, a))          otherwise
//
// R is the radius; a, b, c are coordinates relative to the centre. C is odd in a, b and c; it has the sign of
// a b c. Consider the octant (eighth of space) that contains the corner. There, q(a) is the volume of the
// sphere beyond the plane x = a. The volume q(a, b) lies beyond both planes x = a and y = b. No volume lies
// beyond all three planes if the corner lies outside the sphere. The volume in a box is the alternating sum
// of C over its eight corners.
//
//   q(a)    = pi (R - a)^2 (2 R + a) / 12
//   q(a, b) = (R^3 alpha + a b s)/3 - a (3 R^2 - a^2) psi_a/6 - b (3 R^2 - b^2) psi_b/6
//
//   s^2 = R^2 - a^2 - b^2,  tan alpha = R s/(a b),  tan psi_a = s/b,  tan psi_b = s/a
//
// q(a, b) follows from Gauss's theorem as the flux of r/3 through two plane faces and one spherical face. The
// plane faces are disc segments of half-angles psi at the distances a and b from the centre. The spherical
// face is a lune between small circles that intersect at the angle alpha; its area follows from the
// Gauss-Bonnet theorem. Lengths may have any unit. The errors are of the order of the roundoff of R^3.

namespace beadswim {

/// Returns q(a), the volume of the part of an octant of the sphere beyond the plane x = a. Requires a >= 0.
inline double octant_beyond(double a, double radius) {
  if (a >= radius) return 0;
  return std::numbers::pi / 12 * (radius - a) * (radius - a) * (2 * radius + a);
}

/// Returns q(a, b), the volume of the part of an octant of the sphere beyond both planes x = a and y = b.
/// Requires a, b >= 0.
inline double octant_beyond(double a, double b, double radius) {
  const double rr = radius * radius, s_squared = rr - a * a - b * b;
  if (s_squared <= 0) return 0;
  // clang-format off
  const double s     = std::sqrt(s_squared);
  const double alpha = std::atan2(radius * s, a * b);
  const double psi_a = std::atan2(s, b);
  const double psi_b = std::atan2(s, a);
  return (radius * rr * alpha + a * b * s) / 3
       - a * (3 * rr - a * a) * psi_a / 6
       - b * (3 * rr - b * b) * psi_b / 6;
  // clang-format on
}

/// Sums of the volumes of an octant of the sphere beyond the planes through the corner (a, b, c) of a box,
/// with a, b, c >= 0.
struct CornerCuts {
  double beyond_one;  ///< q(a) + q(b) + q(c)
  double beyond_two;  ///< q(a, b) + q(b, c) + q(c, a)
};

/// Returns C(a, b, c): the signed volume of the part of the sphere in the box from its centre to the corner
/// with coordinates a, b, c. cuts: volumes for the corner |a|, |b|, |c|.
inline double corner_volume(double a, double b, double c, double radius, const CornerCuts& cuts) {
  if (a * a + b * b + c * c <= radius * radius) return a * b * c;
  const double octant = std::numbers::pi / 6 * radius * radius * radius;
  const double within = octant - cuts.beyond_one + cuts.beyond_two;
  return (a < 0) != ((b < 0) != (c < 0)) ? -within : within;
}

}  // namespace beadswim
