#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

// clang-format off
// Lubrication: the film in a small gap h between two spheres resists their relative motion. To leading orders
// in h (Jeffrey & Onishi, J. Fluid Mech. 139 (1984) 261; Kim & Karrila, section 11.2.2):
//
//   squeezing   F    = [ 6 pi eta R^2/h + 6 pi eta R (a^2 + 7 a b + b^2)/(5 (a + b)^2) ln(1/h) + ... ] dh/dt
//
//   sliding     T_a  = - (c_aa w_a + c_ab w_b)
//               T_b  = - (c_ab w_a + c_bb w_b)
//               c_aa = pi eta [ 16/5 R a^2 + 8/125 a^2 ( 8 a^2 +  6 a b + 33 b^2)/(a + b) xi ] ln(1/xi) + ...
//               c_ab = pi eta [  4/5 R a b + 2/125 a b (43 a^2 - 24 a b + 43 b^2)/(a + b) xi ] ln(1/xi) + ...
//
//   a, b        radii [length];  R = a b/(a + b),  xi = 2 h/(a + b);  eta dynamic viscosity [mass/(length time)]
//   F           force between the spheres [mass length/time^2];  T_a, T_b torques [mass length^2/time^2]
//   w_a, w_b    angular velocities across the line of centres, relative to that line as it turns [1/time]
// clang-format on
//
// The forces perpendicular to the line of centres balance the torques. They are n x (T_a + T_b)/r, where n is
// the unit vector along the line and r the distance of the centres. A rigid rotation of the pair therefore
// meets no resistance, and the logarithms of all of Jeffrey & Onishi's functions Y^A, Y^B, Y^C follow. The
// resistance to rotation about the line of centres stays finite as h -> 0 and is left out.
//
// A lattice resolves gaps down to a cutoff h_c. Below h_c it lacks the difference between the resistance at h
// and the resistance at h_c, in which the non-singular terms cancel. The functions below return this
// difference. Any coherent units.

namespace beadswim {

/// Range of gaps in which the resistance of the film is added [length]. Below `smallest` the resistance keeps
/// its value at `smallest`, because real surfaces are rough.
struct LubricationRange {
  double normal = 0;      ///< cutoff h_c of squeezing; 0: nothing is added
  double tangential = 0;  ///< cutoff h_c of sliding; 0: nothing is added
  double smallest = 0;    ///< must be positive if a cutoff is
};

/// Returns R = a b/(a + b).
inline double reduced_radius(double a, double b) {
  return a * b / (a + b);
}

/// Correction of the squeezing resistance at the gap h. `resistance`: resistance at h minus resistance at the
/// cutoff [force time/length]. `momentum`: integral of `resistance` over the gap from the cutoff to h [force
/// time]. It is negative; its absolute value is the momentum that the film removes from spheres that approach
/// to h. Below the smallest gap it is linear in h.
struct Squeezing {
  double resistance = 0, momentum = 0;
};
/// Returns zero for gaps h above the cutoff. viscosity: dynamic.
inline Squeezing squeezing(double a, double b, double viscosity, const LubricationRange& range, double h) {
  if (range.normal == 0 || h >= range.normal) return {};
  // clang-format off
  // The resistance S (1/h - 1/h_c) + L ln(h_c/h), and its integral over h
  const double R = reduced_radius(a, b), h_c = range.normal;
  const double S = 6 * std::numbers::pi * viscosity * R * R;
  const double L = 6 * std::numbers::pi * viscosity * R * (a * a + 7 * a * b + b * b) / (5 * (a + b) * (a + b));
  const double above = std::max(h, range.smallest), x = above / h_c;
  const double integral = S * (std::log(x) - x + 1)   + L * h_c * (x - 1 - x * std::log(x));
  const double slope    = S * (1 / above   - 1 / h_c) - L * std::log(x);
  // clang-format on
  return {.resistance = slope, .momentum = integral + slope * (h - above)};
}

/// c_aa, c_ab and c_bb at the gap h, minus their values at the cutoff [force length time].
struct Sliding {
  double aa = 0, ab = 0, bb = 0;
};
/// Returns zero for gaps h above the cutoff. viscosity: dynamic.
inline Sliding sliding(double a, double b, double viscosity, const LubricationRange& range, double h) {
  if (range.tangential == 0 || h >= range.tangential) return {};
  // clang-format off
  // ln(1/xi) and xi ln(1/xi)/(125 (a + b)), minus their values at the cutoff
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
