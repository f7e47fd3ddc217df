#pragma once

#include <complex>
#include <optional>

#include "beadswim/core/box.hpp"
#include "beadswim/mobility/line_kernel.hpp"
#include "beadswim/mobility/periodic_stokes.hpp"

// Flow along x on a line along x, by forces along x on the same line: in unbounded fluid, or in a box whose
// axes are periodic or have free-slip walls.
//
// A free-slip wall is a mirror: the box becomes periodic with twice the length, with a copy of each force. A
// mirror in y or z keeps the force; one in x reverses it, so with f the kernel of the doubled periodic box
//
//   K(x_r, x_s) = f(x_r - x_s) - f(x_r + x_s)      with walls on x,      f(x_r - x_s)      otherwise
//
// In a periodic box the steady flow has no mean (the wavevector 0 is left out); the unsteady flow has its
// uniform part 1 / (eta alpha^2 V), the acceleration of the whole fluid. Both agree where forces sum to zero.
//
// Pages: docs/method/boxes.md, docs/method/unsteady-stokes.md.

namespace beadswim {

class LineFlow {
 public:
  /// Unbounded fluid of dynamic viscosity eta [mass/(length time)].
  explicit LineFlow(double viscosity) : viscosity_(viscosity) {}

  /// In a box, on the line at (y, z) [length]. Throws InputError unless the lengths are finite and positive
  /// and the line lies between the walls.
  LineFlow(double viscosity, const Box& box, double y, double z);

  /// The flow of one bead at another. Receiver and source [length] are different places (in a periodic box:
  /// not a period apart), between the walls if x has any. Throws InputError otherwise.
  SteadyFlow steady(double receiver, double source) const;

  /// The flow of a bead at its own place by its images alone, without its own singular part; 0 if unbounded.
  SteadyFlow steady_images(double place) const;

  /// The same at a frequency: alpha = sqrt(i omega rho / eta) [1/length], |arg alpha| <= pi/4 and alpha != 0.
  UnsteadyFlow unsteady(std::complex<double> alpha, double receiver, double source) const;
  UnsteadyFlow unsteady_images(std::complex<double> alpha, double place) const;

 private:
  void check_places(double receiver, double source) const;
  void check_between_walls(double place) const;

  double viscosity_;
  std::optional<PeriodicStokes> periodic_;
  std::optional<double> wall_;  ///< place of the far x wall, if x has walls
};

}  // namespace beadswim
