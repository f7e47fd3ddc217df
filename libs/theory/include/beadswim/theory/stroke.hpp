#pragma once

#include <array>
#include <complex>

namespace beadswim {

/// Oscillation of the two arms (4.1): L_i(t) = mean_i + d_i cos(omega t + delta_i).
struct Stroke {
  std::array<double, 2> amplitude{};  ///< d_i >= 0 [length]
  std::array<double, 2> phase{};      ///< delta_i in (-pi, pi] [radian]; 0 where d_i is 0

  /// sin(delta_1 - delta_2); 0 if an arm is at rest, as it then has no phase.
  double sin_phase_shift() const;

  /// d_1 d_2 sin(delta_1 - delta_2): what a velocity is proportional to [length^2].
  double area() const;
};

/// The stroke of arms that change by Re(x_i exp(i omega t)).
Stroke stroke_of(const std::array<std::complex<double>, 2>& complex_amplitude);

}  // namespace beadswim
