#pragma once

#include <complex>
#include <memory>
#include <optional>

#include "beadswim/collinear/line_kernel.hpp"
#include "beadswim/core/box.hpp"

// Velocity along x on a line parallel to x, caused by forces along x on this line. The fluid is unbounded or
// fills a box. Each axis of the box is periodic or has free-slip walls.
//
// A free-slip wall acts as a mirror. An axis with walls is replaced by a periodic axis of twice the length,
// with a mirror image of each force. Mirrors in y or z keep the sign of a force along x. Mirrors in x reverse
// it. Let K(x_r, x_s) be the velocity at x_r per force at x_s, and f(d) the velocity in the periodic box at
// the displacement d along x from a force, per force [time/mass]. Then
//
//   K(x_r, x_s) = f(x_r - x_s) - f(x_r + x_s)      with walls on x,      f(x_r - x_s)      otherwise
//
// In a periodic box the mean of the steady flow is zero, because the wavevector 0 is left out. The unsteady
// flow per force includes the uniform flow 1/(eta alpha^2 V), by which a force accelerates the entire fluid.
// V is the volume of the periodic box and alpha^2 = i omega rho/eta. If the forces sum to zero, the means of
// the steady and of the unsteady flow are zero.
//
// Pages: docs/method/boxes.md, docs/method/unsteady-stokes.md.

namespace beadswim {

class PeriodicStokes;

class LineFlow {
 public:
  /// Sets up the flow in unbounded fluid of dynamic viscosity eta [mass/(length time)].
  explicit LineFlow(double viscosity) : viscosity_(viscosity) {}

  /// Sets up the flow in a box on the line at (y, z) [length]. Throws InputError unless the lengths of the
  /// box are finite and positive and the line lies between the walls.
  LineFlow(double viscosity, const Box& box, double y, double z);

  /// Evaluates the steady velocity along x at x = `receiver` per force along x at x = `source` [length].
  /// Throws InputError if these positions coincide, if they differ by a multiple of the period of the box, or
  /// if one of them is not between the walls.
  SteadyFlow steady(double receiver, double source) const;

  /// Evaluates the steady velocity that the images of a force cause at its position x = `place` [length], per
  /// force. The singular flow of the force itself is left out. Returns 0 in unbounded fluid.
  SteadyFlow steady_images(double place) const;

  /// Evaluate the velocities of steady() and steady_images() for forces that oscillate as exp(i omega t), as
  /// complex amplitudes per force. alpha = sqrt(i omega rho/eta) [1/length]. Throw InputError if alpha is 0,
  /// if |arg alpha| > pi/4, or for positions at which steady() and steady_images() throw it.
  UnsteadyFlow unsteady(std::complex<double> alpha, double receiver, double source) const;
  UnsteadyFlow unsteady_images(std::complex<double> alpha, double place) const;

 private:
  void check_places(double receiver, double source) const;
  void check_between_walls(double place) const;

  double viscosity_;
  std::shared_ptr<const PeriodicStokes> periodic_;  ///< null in unbounded fluid
  std::optional<double> wall_;  ///< position of the upper x wall [length]; none if x is periodic
};

}  // namespace beadswim
