#include "beadswim/collinear/line_flow.hpp"

#include "beadswim/collinear/unsteady_stokes.hpp"
#include "beadswim/core/error.hpp"
#include "periodic_flow.hpp"

namespace beadswim {

namespace {

SteadyFlow unbounded_steady(double viscosity, double displacement) {
  const double r = std::abs(displacement);
  const double oseen = 1 / (4 * std::numbers::pi * viscosity * r);
  const double laplacian = -oseen / (3 * r * r);
  return {.oseen = displacement_kernel(oseen, -oseen / displacement),
          .laplacian = displacement_kernel(laplacian, -3 * laplacian / displacement)};
}

/// Subtracts the flow of the mirror images behind walls in x. `mirrored`: flow of the source at -x_s.
template <class T>
void subtract_mirror(LineKernel<T>& kernel, const LineKernel<T>& mirrored) {
  kernel.value -= mirrored.value;
  kernel.by_receiver -= mirrored.by_receiver;
  kernel.by_source += mirrored.by_source;
}

SteadyFlow between_walls(SteadyFlow flow, const SteadyFlow& mirrored) {
  subtract_mirror(flow.oseen, mirrored.oseen);
  subtract_mirror(flow.laplacian, mirrored.laplacian);
  return flow;
}

UnsteadyFlow between_walls(UnsteadyFlow flow, const UnsteadyFlow& mirrored) {
  subtract_mirror(flow.helmholtz, mirrored.helmholtz);
  subtract_mirror(flow.harmonic, mirrored.harmonic);
  subtract_mirror(flow.total, mirrored.total);
  return flow;
}

void check_alpha(std::complex<double> alpha) {
  constexpr double roundoff = 1e-9;
  const bool is_valid = std::isfinite(std::abs(alpha)) && alpha.real() > 0 &&
                        std::abs(alpha.imag()) <= alpha.real() * (1 + roundoff);
  if (is_valid) return;
  throw InputError("flow on a line",
                   "the inverse penetration depth alpha = sqrt(i omega rho / eta) is {:f} + {:f} i; use the "
                   "square root with positive real part",
                   alpha.real(), alpha.imag());
}

}  // namespace

LineFlow::LineFlow(double viscosity, const Box& box, double y, double z)
    : viscosity_(viscosity),
      periodic_(std::make_shared<PeriodicStokes>(viscosity, periodic_line(box, y, z))) {
  if (box.has_mirrors(0)) wall_ = box.lengths[0];
}

void LineFlow::check_places(double receiver, double source) const {
  const double distance = receiver - source;
  if (periodic_ ? std::remainder(distance, periodic_->line().period) == 0 : distance == 0) {
    throw InputError("flow on a line",
                     "the point force and the point where its flow is evaluated are both at x = {:f}; move "
                     "one of the points",
                     receiver);
  }
  check_between_walls(receiver);
  check_between_walls(source);
}

void LineFlow::check_between_walls(double place) const {
  if (!wall_ || (place > 0 && place < *wall_)) return;
  throw InputError(
      "flow on a line",
      "the position x = {:f} is not between the walls at x = 0 and x = {:f}; move the point or the walls",
      place, *wall_);
}

SteadyFlow LineFlow::steady(double receiver, double source) const {
  check_places(receiver, source);
  if (!periodic_) return unbounded_steady(viscosity_, receiver - source);
  const SteadyFlow flow = periodic_->at(receiver - source);
  return wall_ ? between_walls(flow, periodic_->at(receiver + source)) : flow;
}

SteadyFlow LineFlow::steady_images(double place) const {
  check_between_walls(place);
  if (!periodic_) return {};
  const SteadyFlow images = periodic_->images();
  return wall_ ? between_walls(images, periodic_->at(2 * place)) : images;
}

UnsteadyFlow LineFlow::unsteady(std::complex<double> alpha, double receiver, double source) const {
  check_alpha(alpha);
  check_places(receiver, source);
  if (!periodic_) return unsteady_stokeslet(viscosity_, alpha, receiver - source, 0);
  const PeriodicUnsteadyStokes periodic(*periodic_, alpha);
  const UnsteadyFlow flow = periodic.at(receiver - source);
  return wall_ ? between_walls(flow, periodic.at(receiver + source)) : flow;
}

UnsteadyFlow LineFlow::unsteady_images(std::complex<double> alpha, double place) const {
  check_alpha(alpha);
  check_between_walls(place);
  if (!periodic_) return {};
  const PeriodicUnsteadyStokes periodic(*periodic_, alpha);
  const UnsteadyFlow images = periodic.images();
  return wall_ ? between_walls(images, periodic.at(2 * place)) : images;
}

}  // namespace beadswim
