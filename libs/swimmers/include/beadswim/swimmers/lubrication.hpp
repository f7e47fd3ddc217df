#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

// clang-format off
// Two spheres whose surfaces are a small gap h apart resist relative motion by the film between them, to leading orders in h
// (Jeffrey & Onishi, J. Fluid Mech. 139 (1984) 261; Kim & Karrila, section 11.2.2):
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
// Forces across the line are those that balance the torques, n x (T_a + T_b)/r with
// r the distance of the centres, so that a rigid turn of the pair meets no resistance, and the logarithms of
// all of Jeffrey & Onishi's Y^A, Y^B, Y^C follow. Turning about the line itself meets none that grows.
//
// A lattice resolves gaps down to some cut-off h_c; below, it lacks the difference between the resistance at
// h and that at h_c, in which what is not singular cancels. Any coherent units.

namespace beadswim {

/// Gaps between which the film is added [length]. Below `smallest` it resists as there: surfaces are rough.
struct LubricationRange {
  double normal = 0;      ///< h_c of squeezing; 0: none
  double tangential = 0;  ///< h_c of sliding; 0: none
  double smallest = 0;    ///< greater than 0 where there is a range
};

inline double reduced_radius(double a, double b) {
  return a * b / (a + b);
}

/// Resistance to squeezing beyond that at the cut-off, at a gap below it [force time/length], and its
/// integral over the gap from the cut-off [force time]: what momentum the film takes from spheres that come
/// as near, negative; straight below the smallest gap.
struct Squeezing {
  double resistance = 0, momentum = 0;
};
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

/// c_aa, c_ab, c_bb beyond those at the cut-off [force length time].
struct Sliding {
  double aa = 0, ab = 0, bb = 0;
};
inline Sliding sliding(double a, double b, double viscosity, const LubricationRange& range, double h) {
  if (range.tangential == 0 || h >= range.tangential) return {};
  // clang-format off
  // ln(1/xi), and xi ln(1/xi)/(125 (a + b)), beyond those at the cut-off
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
