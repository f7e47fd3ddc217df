#include "periodic_flow.hpp"

// Steady Stokes flow of a periodic lattice of forces along x. The velocity along x per force, G_xx, is
// evaluated on the line of the forces by an Ewald sum with Hasimoto's splitting. For one force in unbounded
// fluid, G_xx follows from the biharmonic function H, whose Fourier transform is 1/k^4:
//
//   G_xx = (1/eta) (-d^2/dy^2 - d^2/dz^2) H,    1/k^4 = integral_0^oo s exp(-k^2 s) ds
//
// The integral is divided at s = 1/(4 xi^2). The part above this s gives a sum over wavevectors k, the part
// below it gives a sum over the images of the force. Both sums converge fast:
//
//   waves:  (1/(eta V)) sum_{k != 0} (k_y^2 + k_z^2)/k^4 (1 + k^2/(4 xi^2)) exp(-k^2/(4 xi^2)) cos(k.d)
//   images: (1/(4 pi eta)) sum [ B_0 - rho^2 B_1/2 ]
//           B_0 = erfc(xi r)/r,  B_n = [ (2n - 1) B_{n-1} + (2 xi^2)^n/(xi sqrt(pi)) exp(-xi^2 r^2) ]/r^2
//
// xi is the splitting parameter [1/length], V the volume of the lattice cell, and d the vector from the force
// to the receiver. (x, rho) is the vector from an image to the receiver, along and across the line, and r its
// length.
//
// References: Hasimoto, J. Fluid Mech. 5, 317 (1959); Beenakker, J. Chem. Phys. 85, 1581 (1986) for the
// Rotne-Prager tensor.

namespace beadswim {

namespace {

constexpr double pi = std::numbers::pi;

// clang-format off
/// Evaluates the contribution of one image to G_xx and to (1/6) laplacian G_xx, times 4 pi eta: its part of
/// the integral over s < 1/(4 xi^2). (x, rho) is the vector from the image to the receiver, and rho2 = rho^2.
/// With g = 2 xi exp(-xi^2 r^2)/sqrt(pi) and d B_n/dx = -x B_{n+1}:
///
///   oseen      B_0 - rho^2 B_1/2
///   laplacian  (1/6) [ rho^2 B_2 - 2 B_1 + 2 xi^2 g (1 - xi^2 rho^2) ]
///
/// The last term is due to the upper limit of the integral.
SteadyFlow screened_image(double x, double rho2, double xi) {
  const double r2 = x * x + rho2, r = std::sqrt(r2), xi2 = xi * xi;
  const double g   = 2 * xi / std::sqrt(pi) * std::exp(-xi2 * r2);
  const double b0  = std::erfc(xi * r) / r;
  const double b1  = (    b0 +                 g) / r2;
  const double b2  = (3 * b1 + 2 * xi2 *       g) / r2;
  const double b3  = (5 * b2 + 4 * xi2 * xi2 * g) / r2;
  const double cut = 2 * xi2 * g;
  return {.oseen     = displacement_kernel(b0 - rho2 * b1 / 2, x * (-b1 + rho2 * b2 / 2)),
          .laplacian = displacement_kernel((rho2 * b2 - 2 * b1 + cut * (1 - xi2 * rho2)) / 6,
                                           x * (2 * b2 - rho2 * b3 - 2 * xi2 * cut * (1 - xi2 * rho2)) / 6)};
}
// clang-format on

}  // namespace

PeriodicStokes::PeriodicStokes(double viscosity, const PeriodicLine& line)
    : viscosity_(viscosity), line_(line), image_lines_(image_lines(line, line.image_cutoff())) {
  const double tau = 1 / (4 * line.splitting * line.splitting);
  // With g = k_t^2/k^4 (1 + k^2 tau) exp(-k^2 tau) and k_t^2 = k_y^2 + k_z^2, the terms are g and -g k^2/6.
  waves_ = sum_over_transverse_waves<double>(line, [&](auto& sum, const PeriodicLine::Wave& wave, double k2) {
    if (wave.square == 0) return;
    const double term = wave.weight * wave.square / k2 * (1 + k2 * tau) * std::exp(-k2 * tau);
    sum[0] += term / k2;
    sum[1] -= term / 6;
  });
  for (std::size_t n = 0; n < waves_.size(); ++n) {
    const double scale = (n == 0 ? 1 : 2) / (viscosity * line.volume());
    for (double& amplitude : waves_[n]) amplitude *= scale;
  }
}

SteadyFlow PeriodicStokes::at(double displacement) const {
  SteadyFlow near;
  const double scale = 1 / (4 * pi * viscosity_);
  for_each_image(line_.period, image_lines_, line_.image_cutoff(), displacement, [&](double x, double rho2) {
    const auto image = screened_image(x, rho2, line_.splitting);
    near.oseen += scale * image.oseen;
    near.laplacian += scale * image.laplacian;
  });
  auto [oseen, laplacian] = sum_over_waves(waves_, line_, displacement);
  oseen += near.oseen;
  laplacian += near.laplacian;
  return {.oseen = oseen, .laplacian = laplacian};
}

SteadyFlow PeriodicStokes::images() const {
  SteadyFlow flow = at(0);
  // The sum over wavevectors contains the part s > 1/(4 xi^2) of the flow of the source itself. Its limit at
  // r = 0 is subtracted.
  const double xi = line_.splitting;
  const double own = xi / (2 * viscosity_ * std::pow(pi, 1.5));
  flow.oseen.value -= own;
  flow.laplacian.value += 5 * own * xi * xi / 9;
  return flow;
}

}  // namespace beadswim
