#pragma once

#include <array>
#include <complex>

namespace beadswim {

/// Harmonic oscillation of the two arms (4.1): L_i(t) = mean_i + d_i cos(omega t + delta_i).
struct Stroke {
  std::array<double, 2> amplitude{};  ///< d_i >= 0 [length]
  std::array<double, 2> phase{};      ///< delta_i in (-pi, pi] [radian]; 0 where d_i is 0

  /// Returns sin(delta_1 - delta_2), or 0 if an arm is at rest and its phase is undefined.
  double sin_phase_shift() const;

  /// Returns d_1 d_2 sin(delta_1 - delta_2), to which the velocity is proportional [length^2].
  double area() const;
};

/// Returns the stroke of arms that change by Re(x_i exp(i omega t)), x = `complex_amplitude`.
Stroke stroke_of(const std::array<std::complex<double>, 2>& complex_amplitude);

}  // namespace beadswim
