#pragma once

#include <complex>
#include <optional>

#include "beadswim/core/box.hpp"
#include "beadswim/mobility/line_kernel.hpp"
#include "beadswim/mobility/periodic_stokes.hpp"

// Velocity along x on a line parallel to x, caused by forces along x on this line. The fluid is unbounded or
// fills a box. Each axis of the box is periodic or has free-slip walls.
//
// A free-slip wall acts as a mirror. An axis with walls is replaced by a periodic axis of twice the length,
// with a mirror image of each force. Mirrors in y or z keep the sign of a force along x. Mirrors in x reverse
// it. K(x_r, x_s) is the velocity at x_r per force at x_s. f is the velocity per force in the periodic box.
//
//   K(x_r, x_s) = f(x_r - x_s) - f(x_r + x_s)      with walls on x,      f(x_r - x_s)      otherwise
//
// In a periodic box the mean of the steady flow is zero, because the wavevector 0 is left out. The unsteady
// flow per force includes the uniform flow 1/(eta alpha^2 V), by which a force accelerates the entire fluid.
// Here V is the volume of the box and alpha^2 = i omega rho / eta. If the forces sum to zero, the mean of
// both flows is zero.
//
// Pages: docs/method/boxes.md, docs/method/unsteady-stokes.md.

namespace beadswim {

class LineFlow {
 public:
  /// Sets up the flow in unbounded fluid of dynamic viscosity eta [mass/(length time)].
  explicit LineFlow(double viscosity) : viscosity_(viscosity) {}

  /// Sets up the flow in a box on the line at (y, z) [length]. Throws InputError unless the lengths of the
  /// box are finite and positive and the line lies between the walls.
  LineFlow(double viscosity, const Box& box, double y, double z);

  /// Evaluates the velocity at `receiver` per force at `source` (positions [length]). Throws InputError if
  /// the positions coincide, if they differ by a multiple of the period of the box, or if a position is not
  /// between the walls.
  SteadyFlow steady(double receiver, double source) const;

  /// Evaluates the velocity that the images of a force cause at the position of the force, per force. The
  /// singular flow of the force itself is left out. Returns 0 in unbounded fluid.
  SteadyFlow steady_images(double place) const;

  /// Unsteady flow at the angular frequency omega: evaluate the quantities of steady() and steady_images()
  /// for alpha = sqrt(i omega rho / eta) [1/length]. Throw InputError in the same cases, and if alpha is 0 or
  /// |arg alpha| > pi/4.
  UnsteadyFlow unsteady(std::complex<double> alpha, double receiver, double source) const;
  UnsteadyFlow unsteady_images(std::complex<double> alpha, double place) const;

 private:
  void check_places(double receiver, double source) const;
  void check_between_walls(double place) const;

  double viscosity_;
  std::optional<PeriodicStokes> periodic_;
  std::optional<double> wall_;  ///< position of the upper x wall [length]; none if x is periodic
};

}  // namespace beadswim
