#pragma once

#include <complex>
#include <vector>

namespace beadswim {

/// Harmonic oscillation of the lengths L_i of the arms, equation (4.1) of Pickl et al. 2017:
/// L_i(t) = mean_i + d_i cos(omega t + delta_i). An arm is a bond of the swimmer; the default is two arms at
/// rest.
struct Stroke {
  std::vector<double> amplitude = std::vector<double>(2);  ///< d_i >= 0 [length]
  std::vector<double> phase = std::vector<double>(2);  ///< delta_i in (-pi, pi] [radian]; 0 where d_i is 0

  /// Returns sin(delta_1 - delta_2) of the first two arms, or 0 if one of them is at rest and its phase is
  /// undefined.
  double sin_phase_shift() const;

  /// Returns d_1 d_2 sin(delta_1 - delta_2) [length^2]. To second order in the arm amplitudes d_i, the
  /// swimmer's velocity is proportional to this product.
  double area() const;
};

/// Returns the stroke of arms whose lengths change by Re(x_i exp(i omega t)), x = `complex_amplitude`
/// [length].
Stroke stroke_of(const std::vector<std::complex<double>>& complex_amplitude);

}  // namespace beadswim
