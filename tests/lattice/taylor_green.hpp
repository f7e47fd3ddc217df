#pragma once

#include <cmath>
#include <numbers>

#include "beadswim/lattice/populations.hpp"

namespace beadswim::test {

/// Returns density and velocity of the Taylor-Green vortex in the plane of two axes, x and y, at time t = 0.
/// speed: U; period: n; k = 2 pi/n:
///   u = U (cos kx sin ky, -sin kx cos ky) exp(-2 nu k^2 t),
///   p = -U^2/4 (cos 2kx + cos 2ky) exp(-4 nu k^2 t).
inline CellMoments taylor_green(double speed, double period, const Vec3& place, int x_axis, int y_axis) {
  const double k = 2 * std::numbers::pi / period;
  const double x = k * place[x_axis], y = k * place[y_axis];
  const double pressure = -speed * speed / 4 * (std::cos(2 * x) + std::cos(2 * y));
  Vec3 velocity = Vec3::Zero();
  velocity[x_axis] = speed * std::cos(x) * std::sin(y);
  velocity[y_axis] = -speed * std::sin(x) * std::cos(y);
  return {.density_deviation = 3 * pressure, .momentum = velocity};
}

}  // namespace beadswim::test
