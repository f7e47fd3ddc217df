#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

// clang-format off
// Lubrication: the film in a small gap h between two spheres resists their relative motion. The leading terms
// for small h are (Jeffrey & Onishi, J. Fluid Mech. 139 (1984) 261; Kim & Karrila, section 11.2.2):
//
//   squeezing   F    = [ 6 pi eta R^2/h + 6 pi eta R (a^2 + 7 a b + b^2)/(5 (a + b)^2) ln(1/h) + ... ] dh/dt
//
//   sliding     T_a  = - (c_aa w_a + c_ab w_b)
//               T_b  = - (c_ab w_a + c_bb w_b)
//               c_aa = pi eta [ 16/5 R a^2 + 8/125 a^2 ( 8 a^2 +  6 a b + 33 b^2)/(a + b) xi ] ln(1/xi) + ...
//               c_ab = pi eta [  4/5 R a b + 2/125 a b (43 a^2 - 24 a b + 43 b^2)/(a + b) xi ] ln(1/xi) + ...
//
//   a, b        radii [length];  R = a b/(a + b),  xi = 2 h/(a + b)
//   eta         dynamic viscosity [mass/(length time)]
//   F           force between the spheres [mass length/time^2];  T_a, T_b torques [mass length^2/time^2]
//   w_a, w_b    angular velocities of the spheres [1/time], perpendicular to the line of centres, in a frame
//               that rotates with this line
// clang-format on
//
// The forces perpendicular to the line of centres balance the torques. They are n x (T_a + T_b)/r, where n is
// the unit vector along the line and r the distance of the centres. A rotation of the pair as a rigid body
// therefore causes no resistance. These relations reproduce the logarithmic terms of all functions Y^A, Y^B,
// Y^C of Jeffrey & Onishi. The resistance to rotation about the line of centres stays finite as h -> 0 and is
// omitted.
//
// A lattice resolves the film at gaps down to a cutoff h_c. At smaller gaps, the resistance on the lattice
// stays at its value at h_c. The functions below return the missing part: the resistance at h minus the
// resistance at h_c. The non-singular terms cancel in this difference. Quantities are in any coherent units.

namespace beadswim {

/// Range of gaps between two spheres in which the resistance of the film is added [length]. At gaps below
/// `smallest` the resistance keeps its value at `smallest`, because real surfaces are rough.
struct LubricationRange {
  double normal = 0;      ///< largest gap at which resistance to squeezing is added; 0: none is added
  double tangential = 0;  ///< largest gap at which resistance to sliding is added; 0: none is added
  double smallest = 0;    ///< largest gap with constant resistance; must be > 0 if a cutoff is > 0
};

/// Returns the reduced radius R = a b/(a + b) of two spheres with the radii a and b [length].
inline double reduced_radius(double a, double b) {
  return a * b / (a + b);
}

/// Resistance to squeezing that a lattice lacks at the gap h between two spheres.
///   resistance  resistance at h minus resistance at the cutoff, LubricationRange::normal [force time/length]
///   momentum    integral of `resistance` over the gap, from the cutoff to h [force time]
/// The momentum is negative. Its absolute value is the momentum that the film removes from two spheres while
/// their gap decreases from the cutoff to h. At gaps below LubricationRange::smallest, where the resistance
/// is constant, the momentum is linear in h.
struct Squeezing {
  double resistance = 0, momentum = 0;
};
/// Returns the correction for spheres of radii a and b at the gap h. It is zero if h exceeds the cutoff.
/// viscosity: dynamic viscosity [mass/(length time)].
inline Squeezing squeezing(double a, double b, double viscosity, const LubricationRange& range, double h) {
  if (range.normal == 0 || h >= range.normal) return {};
  // clang-format off
  // slope is the resistance S (1/h - 1/h_c) + L ln(h_c/h), and integral is its integral from h_c to h.
  const double R = reduced_radius(a, b), h_c = range.normal;
  const double S = 6 * std::numbers::pi * viscosity * R * R;
  const double L = 6 * std::numbers::pi * viscosity * R * (a * a + 7 * a * b + b * b) / (5 * (a + b) * (a + b));
  const double above = std::max(h, range.smallest), x = above / h_c;
  const double integral = S * (std::log(x) - x + 1)   + L * h_c * (x - 1 - x * std::log(x));
  const double slope    = S * (1 / above   - 1 / h_c) - L * std::log(x);
  // clang-format on
  return {.resistance = slope, .momentum = integral + slope * (h - above)};
}

/// Resistance to sliding that a lattice lacks at the gap h between spheres a and b. `aa`, `ab` and `bb` are
/// the coefficients in the torques T_a = -(aa w_a + ab w_b) and T_b = -(ab w_a + bb w_b) at h, minus their
/// values at the cutoff, LubricationRange::tangential [force length time]. w_a and w_b are the angular
/// velocities of the spheres relative to their line of centres [1/time].
struct Sliding {
  double aa = 0, ab = 0, bb = 0;
};
/// Returns the correction for spheres of radii a and b at the gap h. It is zero if h exceeds the cutoff.
/// viscosity: dynamic viscosity [mass/(length time)].
inline Sliding sliding(double a, double b, double viscosity, const LubricationRange& range, double h) {
  if (range.tangential == 0 || h >= range.tangential) return {};
  // clang-format off
  // log is ln(1/xi), and higher is xi ln(1/xi)/(125 (a + b)), each minus its value at the cutoff.
  const double xi     = 2 * std::max(h, range.smallest) / (a + b);
  const double xi_c   = 2 * range.tangential            / (a + b);
  const double log    = std::log(xi_c / xi);
  const double higher = (xi_c * std::log(xi_c) - xi * std::log(xi)) / (125 * (a + b));
  const double R = reduced_radius(a, b), unit = std::numbers::pi * viscosity;
  const auto self = [&](double a, double b) {
    return unit * a * a * (16.0 / 5 * R * log + 8 * ( 8 * a * a +  6 * a * b + 33 * b * b) * higher);
  };
  return {.aa = self(a, b),
          .ab = unit * a * b * ( 4.0 / 5 * R * log + 2 * (43 * a * a - 24 * a * b + 43 * b * b) * higher),
          .bb = self(b, a)};
  // clang-format on
}

}  // namespace beadswim
