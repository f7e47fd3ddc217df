#pragma once

#include <cmath>
#include <numbers>

// Exact volume of the part of a sphere that lies in an axis-parallel box.
//
//   C(a, b, c) = signed volume of the sphere within the box from its centre to the corner (a, b, c)
//              = a b c                                                 if the corner lies inside, else
//              = +- (pi R^3/6 - q(a) - q(b) - q(c) + q(a, b) + q(b, c) + q(c, a))
//
// C is odd in a, b and c. In the octant of the corner, q(a) is the volume of the sphere beyond the plane x =
// a, and q(a, b) the volume beyond both x = a and y = b. If the corner lies outside the sphere, no volume
// lies beyond all three planes. The volume in a box is the alternating sum of C over its eight corners.
//
//   q(a)    = pi (R - a)^2 (2 R + a) / 12
//   q(a, b) = (R^3 alpha + a b s)/3 - a (3 R^2 - a^2) psi_a/6 - b (3 R^2 - b^2) psi_b/6
//
//   s^2 = R^2 - a^2 - b^2,  tan alpha = R s/(a b),  tan psi_a = s/b,  tan psi_b = s/a
//
// q(a, b) follows from Gauss's theorem as the flux of r/3 through two plane faces and one spherical face. The
// plane faces are disc segments of half-angles psi at distances a and b. The spherical face is a lune between
// small circles that intersect at the angle alpha; its area follows from the Gauss-Bonnet theorem. Any unit
// of length. The errors are of the order of the roundoff of R^3.

namespace beadswim {

/// Returns q(a) for a >= 0.
inline double octant_beyond(double a, double radius) {
  if (a >= radius) return 0;
  return std::numbers::pi / 12 * (radius - a) * (radius - a) * (2 * radius + a);
}

/// Returns q(a, b) for a, b >= 0.
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

/// Cut-off volumes at the absolute values of the coordinates of a corner.
struct CornerCuts {
  double beyond_one;  ///< q(a) + q(b) + q(c)
  double beyond_two;  ///< q(a, b) + q(b, c) + q(c, a)
};

/// Returns C(a, b, c).
inline double corner_volume(double a, double b, double c, double radius, const CornerCuts& cuts) {
  if (a * a + b * b + c * c <= radius * radius) return a * b * c;
  const double octant = std::numbers::pi / 6 * radius * radius * radius;
  const double within = octant - cuts.beyond_one + cuts.beyond_two;
  return (a < 0) != ((b < 0) != (c < 0)) ? -within : within;
}

}  // namespace beadswim
