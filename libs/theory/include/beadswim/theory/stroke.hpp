#pragma once

#include <Eigen/Core>
#include <limits>
#include <optional>
#include <vector>

#include "beadswim/swimmers/force_dipole.hpp"

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
Stroke stroke_of(const Eigen::VectorXcd& complex_amplitude);

/// Mean motion and stroke of a swimmer over a period of its driving, to second order in the driving or at
/// finite amplitude.
struct PeriodicMotion {
  double velocity = 0;  ///< V along the axis of the swimmer; of a line, towards bead 3 [length/time]
  Stroke stroke;        ///< first harmonic of the arm lengths
  std::vector<double> arm_changes;  ///< mean arm lengths minus rest lengths [length]
  /// Smallest gap between surfaces of beads, or of a bead and a wall, in the motion [length].
  double smallest_gap = std::numeric_limits<double>::infinity();
  std::optional<ForceDipole> dipole{};  ///< mean, [mass length^2/time^2]; nullopt if not computed
  int samples = 0;  ///< equidistant times per period at which a motion at finite amplitude was computed
};

}  // namespace beadswim
