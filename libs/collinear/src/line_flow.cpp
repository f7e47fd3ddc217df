#include "beadswim/collinear/line_flow.hpp"

#include <fmt/core.h>

#include <cmath>
#include <numbers>

#include "beadswim/collinear/periodic_unsteady_stokes.hpp"
#include "beadswim/core/error.hpp"

namespace beadswim {

namespace {

SteadyLine unbounded_steady(double viscosity, double displacement) {
  const double r = std::abs(displacement);
  const double oseen = 1 / (4 * std::numbers::pi * viscosity * r);
  const double laplacian = -oseen / (3 * r * r);
  return {.oseen = {.value = oseen, .slope = -oseen / displacement},
          .laplacian = {.value = laplacian, .slope = -3 * laplacian / displacement}};
}

/// Returns the kernel K(x_r, x_s) = f(x_r - x_s) and its derivatives. `direct`: f and its slope at x_r - x_s.
template <class T>
LineKernel<T> make_kernel(const LineValue<T>& direct) {
  return {.value = direct.value, .by_receiver = direct.slope, .by_source = -direct.slope};
}

/// Returns the kernel K(x_r, x_s) = f(x_r - x_s) - f(x_r + x_s) between walls, and its derivatives. `direct`:
/// f and its slope at x_r - x_s, `mirrored`: f and its slope at x_r + x_s.
template <class T>
LineKernel<T> make_kernel(const LineValue<T>& direct, const LineValue<T>& mirrored) {
  return {.value = direct.value - mirrored.value,
          .by_receiver = direct.slope - mirrored.slope,
          .by_source = -direct.slope - mirrored.slope};
}

template <class... Line>
SteadyFlow steady_flow(const Line&... lines) {
  return {.oseen = make_kernel(lines.oseen...), .laplacian = make_kernel(lines.laplacian...)};
}

template <class... Line>
UnsteadyFlow unsteady_flow(const Line&... lines) {
  return {.helmholtz = make_kernel(lines.helmholtz...),
          .harmonic = make_kernel(lines.harmonic...),
          .total = make_kernel(lines.total...)};
}

void check_alpha(std::complex<double> alpha) {
  constexpr double roundoff = 1e-9;
  const bool is_valid = std::isfinite(std::abs(alpha)) && alpha.real() > 0 &&
                        std::abs(alpha.imag()) <= alpha.real() * (1 + roundoff);
  if (is_valid) return;
  throw InputError("flow on a line",
                   fmt::format("the inverse penetration depth alpha = sqrt(i omega rho / eta) is {:f} + {:f} "
                               "i; use the square root with positive real part",
                               alpha.real(), alpha.imag()));
}

}  // namespace

LineFlow::LineFlow(double viscosity, const Box& box, double y, double z)
    : viscosity_(viscosity), periodic_(PeriodicStokes(viscosity, periodic_line(box, y, z))) {
  if (box.has_mirrors(0)) wall_ = box.lengths[0];
}

void LineFlow::check_places(double receiver, double source) const {
  const double distance = receiver - source;
  if (periodic_ ? std::remainder(distance, periodic_->line().period) == 0 : distance == 0) {
    throw InputError("flow on a line", fmt::format("the point force and the point where its flow is "
                                                   "evaluated are both at x = {:f}; move one of the points",
                                                   receiver));
  }
  check_between_walls(receiver);
  check_between_walls(source);
}

void LineFlow::check_between_walls(double place) const {
  if (!wall_ || (place > 0 && place < *wall_)) return;
  throw InputError(
      "flow on a line",
      fmt::format(
          "the position x = {:f} is not between the walls at x = 0 and x = {:f}; move the point or the walls",
          place, *wall_));
}

SteadyFlow LineFlow::steady(double receiver, double source) const {
  check_places(receiver, source);
  if (!periodic_) return steady_flow(unbounded_steady(viscosity_, receiver - source));
  const SteadyLine direct = periodic_->at(receiver - source);
  return wall_ ? steady_flow(direct, periodic_->at(receiver + source)) : steady_flow(direct);
}

SteadyFlow LineFlow::steady_images(double place) const {
  check_between_walls(place);
  if (!periodic_) return {};
  const SteadyLine images = periodic_->images();
  return wall_ ? steady_flow(images, periodic_->at(2 * place)) : steady_flow(images);
}

UnsteadyFlow LineFlow::unsteady(std::complex<double> alpha, double receiver, double source) const {
  check_alpha(alpha);
  check_places(receiver, source);
  if (!periodic_) return unsteady_flow(unsteady_stokeslet(viscosity_, alpha, receiver - source, 0));
  const PeriodicUnsteadyStokes periodic(*periodic_, alpha);
  const UnsteadyLine direct = periodic.at(receiver - source);
  return wall_ ? unsteady_flow(direct, periodic.at(receiver + source)) : unsteady_flow(direct);
}

UnsteadyFlow LineFlow::unsteady_images(std::complex<double> alpha, double place) const {
  check_alpha(alpha);
  check_between_walls(place);
  if (!periodic_) return {};
  const PeriodicUnsteadyStokes periodic(*periodic_, alpha);
  const UnsteadyLine images = periodic.images();
  return wall_ ? unsteady_flow(images, periodic.at(2 * place)) : unsteady_flow(images);
}

}  // namespace beadswim
