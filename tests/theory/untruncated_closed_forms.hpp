#pragma once

#include <cmath>

#include "beadswim/theory/collinear_swimmer.hpp"

// Closed expressions of second order in the amplitude for equal radii, arms and stiffnesses, without
// truncation in e = lambda/l. They were derived by computer algebra, independently of the numerical expansion
// that is tested:
//
//   v = C omega {A B sin(alpha) (k^2 + omega^2 g_s g_m / 3) + (A^2 - B^2)/2 k omega (g_s - g_m / 3)}
//       / {(k^2 + omega^2 g_s^2) (k^2 + omega^2 g_m^2 / 9)}
//
// g_s, g_m: drag coefficients of the modes in which the arms change equally and oppositely.

namespace beadswim {

struct GeometryFactors {
  double C;         ///< v = C omega d1 d2 sin(delta1 - delta2)
  double g_s, g_m;  ///< [mass/time]
};

inline double stokes_drag(const CollinearSwimmer& s) {
  return 6 * std::numbers::pi * s.viscosity * s.radius[0];
}

inline GeometryFactors untruncated_oseen(const CollinearSwimmer& s) {
  const double a = s.radius[0], l = s.arm[0], e = a / l;
  const double C =
      a * (56 * l * l - 198 * l * a + 189 * a * a) / (3 * l * std::pow(4 * l - 7 * a, 2) * (4 * l - 3 * a));
  return {C, stokes_drag(s) / (1 - 3 * e / 4), stokes_drag(s) / (1 - 7 * e / 4)};
}

inline GeometryFactors untruncated_rotne_prager(const CollinearSwimmer& s) {
  const double a = s.radius[0], l = s.arm[0], e = a / l;
  const double numerator = 224 - 792 * e + 260 * std::pow(e, 2) + 2280 * std::pow(e, 3) -
                           2736 * std::pow(e, 4) - 1230 * std::pow(e, 5) + 2847 * std::pow(e, 6) -
                           930 * std::pow(e, 8);  // over l^8
  const double denominator =
      (8 - 6 * e + std::pow(e, 3)) * std::pow(24 - 42 * e + 31 * std::pow(e, 3), 2);  // over l^9
  const double e3 = std::pow(e, 3);
  return {6 * a * numerator / (denominator * l * l), stokes_drag(s) / (1 - 3 * e / 4 + e3 / 8),
          stokes_drag(s) / (1 - 7 * e / 4 + 31 * e3 / 24)};
}

inline double untruncated_velocity(const CollinearSwimmer& s, const GeometryFactors& f) {
  const double A = s.amplitude[0], B = s.amplitude[1], k = s.stiffness[0], w = s.angular_frequency();
  const double braces = A * B * std::sin(s.phase) * (k * k + w * w * f.g_s * f.g_m / 3) +
                        (A * A - B * B) / 2 * k * w * (f.g_s - f.g_m / 3);
  return f.C * w * braces / ((k * k + w * w * f.g_s * f.g_s) * (k * k + w * w * f.g_m * f.g_m / 9));
}

}  // namespace beadswim
