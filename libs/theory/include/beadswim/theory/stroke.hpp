#pragma once

#include <array>
#include <complex>

namespace beadswim {

/// Harmonic oscillation of the lengths L_i of the two arms, equation (4.1) of Pickl et al. 2017:
/// L_i(t) = mean_i + d_i cos(omega t + delta_i).
struct Stroke {
  std::array<double, 2> amplitude{};  ///< d_i >= 0 [length]
  std::array<double, 2> phase{};      ///< delta_i in (-pi, pi] [radian]; 0 where d_i is 0

  /// Returns sin(delta_1 - delta_2), or 0 if an arm is at rest and its phase is undefined.
  double sin_phase_shift() const;

  /// Returns d_1 d_2 sin(delta_1 - delta_2) [length^2]. To second order in the arm amplitudes d_i, the
  /// swimmer's velocity is proportional to this product.
  double area() const;
};

/// Returns the stroke of arms whose lengths change by Re(x_i exp(i omega t)), x = `complex_amplitude`
/// [length].
Stroke stroke_of(const std::array<std::complex<double>, 2>& complex_amplitude);

}  // namespace beadswim
