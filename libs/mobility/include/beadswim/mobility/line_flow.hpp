#pragma once

#include <complex>
#include <optional>

#include "beadswim/core/box.hpp"
#include "beadswim/mobility/line_kernel.hpp"
#include "beadswim/mobility/periodic_stokes.hpp"

// Velocity along x on a line along x, caused by forces along x on the same line. The fluid is unbounded, or
// in a box whose axes are periodic or have free-slip walls.
//
// A free-slip wall is a mirror: the box is replaced by a periodic box of twice the length with a copy of each
// force. A mirror in y or z keeps the sign of the force, a mirror in x reverses it. With the kernel f of the
// periodic box
//
//   K(x_r, x_s) = f(x_r - x_s) - f(x_r + x_s)      with walls on x,      f(x_r - x_s)      otherwise
//
// In a periodic box the mean of the steady flow is zero (the wavevector 0 is left out). The unsteady flow
// includes the uniform flow 1 / (eta alpha^2 V), the acceleration of the entire fluid. Both agree if the
// forces sum to zero.
//
// Pages: docs/method/boxes.md, docs/method/unsteady-stokes.md.

namespace beadswim {

class LineFlow {
 public:
  /// Flow in unbounded fluid of dynamic viscosity eta [mass/(length time)].
  explicit LineFlow(double viscosity) : viscosity_(viscosity) {}

  /// Flow in a box, on the line at (y, z) [length]. Throws InputError unless the lengths are finite and
  /// positive and the line lies between the walls.
  LineFlow(double viscosity, const Box& box, double y, double z);

  /// Evaluates the flow of a force at `source` at the position `receiver` [length]. Throws InputError if the
  /// positions coincide, in a periodic box also if they differ by a multiple of the period, or if one is not
  /// between the walls.
  SteadyFlow steady(double receiver, double source) const;

  /// Evaluates the flow of a force at its own position by its images, without its own singular flow. Returns
  /// 0 in unbounded fluid.
  SteadyFlow steady_images(double place) const;

  /// Evaluate the unsteady flow, with alpha = sqrt(i omega rho / eta) [1/length]. Throw InputError also if
  /// alpha is 0 or |arg alpha| > pi/4.
  UnsteadyFlow unsteady(std::complex<double> alpha, double receiver, double source) const;
  UnsteadyFlow unsteady_images(std::complex<double> alpha, double place) const;

 private:
  void check_places(double receiver, double source) const;
  void check_between_walls(double place) const;

  double viscosity_;
  std::optional<PeriodicStokes> periodic_;
  std::optional<double> wall_;  ///< position of the upper x wall; none if x is periodic [length]
};

}  // namespace beadswim
