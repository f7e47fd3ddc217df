#include "beadswim/collinear/periodic_stokes.hpp"

#include <complex>
#include <numbers>

#include "ewald_cutoff.hpp"

namespace beadswim {

namespace {

constexpr double pi = std::numbers::pi;

/// Sums over the transverse wavevectors (k_y, k_z) for one k_x, with k_t^2 = k_y^2 + k_z^2,
/// k^2 = k_x^2 + k_t^2 and tau = 1/(4 xi^2).
struct TransverseSum {
  double oseen = 0;      ///< sum of g = k_t^2/k^4 (1 + k^2 tau) exp(-k^2 tau)
  double laplacian = 0;  ///< sum of -g k^2/6
};

TransverseSum transverse_sum(const std::vector<PeriodicLine::Wave>& waves, double k_x, double splitting) {
  const double tau = 1 / (4 * splitting * splitting);
  const double longest = max_wavenumber(splitting);
  TransverseSum sum;
  for (const auto& wave : waves) {
    const double k2 = k_x * k_x + wave.square;
    if (wave.square == 0 || k2 > longest * longest) continue;
    const double term = wave.weight * wave.square / k2 * (1 + k2 * tau) * std::exp(-k2 * tau);
    sum.oseen += term / k2;
    sum.laplacian -= term / 6;
  }
  return sum;
}

// clang-format off
/// Evaluates the contribution of one image to G_xx and to (1/6) laplacian G_xx, times 4 pi eta: its part of
/// the integral over s < 1/(4 xi^2) in periodic_stokes.hpp. (x, rho) is the vector from the image to the
/// receiver, and rho2 = rho^2. With g = 2 xi exp(-xi^2 r^2)/sqrt(pi), d B_n/dx = -x B_{n+1} and the B_n of
/// periodic_stokes.hpp:
///
///   oseen      B_0 - rho^2 B_1/2
///   laplacian  (1/6) [ rho^2 B_2 - 2 B_1 + 2 xi^2 g (1 - xi^2 rho^2) ]
///
/// The last term is due to the upper limit of the integral.
SteadyLine screened_image(double x, double rho2, double xi) {
  const double r2 = x * x + rho2, r = std::sqrt(r2), xi2 = xi * xi;
  const double g   = 2 * xi / std::sqrt(pi) * std::exp(-xi2 * r2);
  const double b0  = std::erfc(xi * r) / r;
  const double b1  = (    b0 +                 g) / r2;
  const double b2  = (3 * b1 + 2 * xi2 *       g) / r2;
  const double b3  = (5 * b2 + 4 * xi2 * xi2 * g) / r2;
  const double cut = 2 * xi2 * g;
  return {.oseen     = {.value =       b0 - rho2 * b1 / 2,
                        .slope = x * (-b1 + rho2 * b2 / 2)},
          .laplacian = {.value =     (rho2 * b2 - 2 * b1             + cut * (1 - xi2 * rho2)) / 6,
                        .slope = x * (2 * b2 - rho2 * b3 - 2 * xi2 * cut * (1 - xi2 * rho2)) / 6}};
}
// clang-format on

}  // namespace

PeriodicStokes::PeriodicStokes(double viscosity, const PeriodicLine& line)
    : viscosity_(viscosity), line_(line), image_lines_(image_lines(line, image_cutoff(line.splitting))) {
  const double longest = max_wavenumber(line.splitting);
  const auto waves = transverse_waves(line, longest);
  const double spacing = 2 * pi / line.period;
  for (int n = 0; n * spacing < longest; ++n) {
    const auto sum = transverse_sum(waves, n * spacing, line.splitting);
    const double scale = (n == 0 ? 1 : 2) / (viscosity * line.volume());
    wave_sums_.push_back({.oseen = scale * sum.oseen, .laplacian = scale * sum.laplacian});
  }
}

SteadyLine PeriodicStokes::waves(double displacement) const {
  const double spacing = 2 * pi / line_.period;
  const std::complex<double> step = std::polar(1.0, spacing * displacement);
  std::complex<double> phase = 1;
  SteadyLine sum;
  double k = 0;
  for (const auto& wave : wave_sums_) {
    sum.oseen += wave.oseen * LineValue<double>{phase.real(), -k * phase.imag()};
    sum.laplacian += wave.laplacian * LineValue<double>{phase.real(), -k * phase.imag()};
    phase *= step;
    k += spacing;
  }
  return sum;
}

SteadyLine PeriodicStokes::near_images(double displacement) const {
  SteadyLine sum;
  const double scale = 1 / (4 * pi * viscosity_);
  for_each_image(line_.period, image_lines_, image_cutoff(line_.splitting), displacement,
                 [&](double x, double rho2) {
                   const auto image = screened_image(x, rho2, line_.splitting);
                   sum.oseen += scale * image.oseen;
                   sum.laplacian += scale * image.laplacian;
                 });
  return sum;
}

SteadyLine PeriodicStokes::at(double displacement) const {
  SteadyLine flow = waves(displacement);
  const SteadyLine images = near_images(displacement);
  flow.oseen += images.oseen;
  flow.laplacian += images.laplacian;
  return flow;
}

SteadyLine PeriodicStokes::images() const {
  SteadyLine flow = at(0);
  // The sum over wavevectors contains the part s > 1/(4 xi^2) of the flow of the source itself. Its limit at
  // r = 0 is subtracted.
  const double xi = line_.splitting;
  const double own = xi / (2 * viscosity_ * std::pow(pi, 1.5));
  flow.oseen.value -= own;
  flow.laplacian.value += 5 * own * xi * xi / 9;
  return flow;
}

}  // namespace beadswim
