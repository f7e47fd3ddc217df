#include "beadswim/collinear/periodic_unsteady_stokes.hpp"

#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <numbers>

#include "beadswim/core/complex.hpp"
#include "ewald_cutoff.hpp"

namespace beadswim {

namespace {

constexpr double pi = std::numbers::pi;

/// Evaluates (1 - e^{-z})/z.
Complex mean_decay(Complex z) {
  if (std::abs(z) > 0.5) return (1.0 - std::exp(-z)) / z;
  Complex sum = 1, term = 1;
  for (int n = 2; n <= 16; ++n) {  // 0.5^15/16! = 1e-18
    term *= -z / static_cast<double>(n);
    sum += term;
  }
  return sum;
}

/// Evaluates the complementary error function for |z| < 1.5 by a power series. Its largest term is near 4, so
/// little significance is lost.
Complex complementary_error_function(Complex z) {
  Complex sum = 0, term = z;  // (-1)^n z^{2n+1}/n!
  for (int n = 0; n <= 40; ++n) {
    sum += term / (2 * n + 1.0);
    term *= -z * z / (n + 1.0);
  }
  return 1.0 - 2 / std::sqrt(pi) * sum;
}

/// Sums over the transverse wavevectors (k_y, k_z) for one k_x, with k^2 = k_x^2 + k_y^2 + k_z^2 and
/// tau = 1/(4 xi^2).
struct TransverseSum {
  Complex heat_sum;    ///< sum of exp(-k^2 tau)/(k^2 + alpha^2)
  Complex steady_sum;  ///< sum of exp(-k^2 tau)/(k^2 (k^2 + alpha^2)) without k = 0
};

TransverseSum transverse_sum(const std::vector<PeriodicLine::Wave>& waves, double k_x, Complex alpha2,
                             double splitting) {
  const double tau = 1 / (4 * splitting * splitting);
  const double longest = max_wavenumber(splitting);
  TransverseSum sum;
  for (const auto& wave : waves) {
    const double k2 = k_x * k_x + wave.square;
    if (k2 > longest * longest) continue;
    const Complex term = wave.weight * std::exp(-k2 * tau) / (k2 + alpha2);
    sum.heat_sum += term;
    if (k2 > 0) sum.steady_sum += term / k2;
  }
  return sum;
}

/// Quadrature node of the integrals over s < tau that give the sums over images
/// (periodic_unsteady_stokes.hpp). s = 1/(4 p^2). The weights are factors of exp(-p^2 r^2) and of its second
/// derivative along x.
struct HeatNode {
  double p = 0;
  Complex plain;                           ///< factor of exp(-p^2 r^2) in both integrals
  Complex helmholtz_curved, total_curved;  ///< factors of the second derivative in each integral
};

/// Returns the quadrature nodes for integrals of the heat kernel g_s, with s = 1/(4 p^2) and tau = 1/(4
/// xi^2):
///
///   integral_0^tau f(s) g_s ds = (2 pi^{3/2})^{-1} integral_xi^oo f e^{-p^2 r^2} dp
///
/// The upper limit of p is finite: there the Gaussian is negligible at the distance `nearest` of the nearest
/// image. The integration variable is ln p, because the integrand varies on a scale of 1 in ln p.
std::vector<HeatNode> heat_nodes(double xi, Complex alpha, double nearest) {
  const Complex alpha2 = alpha * alpha;
  const double span = std::log(std::max(gaussian_cutoff / (xi * nearest), 1.2));
  constexpr double longest_panel = 0.7;
  const int panels = static_cast<int>(std::ceil(span / longest_panel));
  using Rule =
      boost::math::quadrature::gauss<long double, 16>;  // Boost's rule for double is inexact in the last bits
  std::vector<HeatNode> nodes;
  const auto add = [&](double y, double weight) {
    const double p = xi * std::exp(y), s = 1 / (4 * p * p);
    const double scale = weight * p / (2 * std::pow(pi, 1.5));
    const Complex decay = scale * std::exp(-alpha2 * s);
    nodes.push_back({.p = p,
                     .plain = decay,
                     .helmholtz_curved = -decay / alpha2,
                     .total_curved = scale * s * mean_decay(alpha2 * s)});
  };
  for (int panel = 0; panel < panels; ++panel) {
    const double from = span * panel / panels, to = span * (panel + 1) / panels;
    const double middle = (from + to) / 2, half = (to - from) / 2;
    for (std::size_t n = 0; n < Rule::abscissa().size(); ++n) {  // nodes in (0, 1); each has a mirror node
      const auto place = static_cast<double>(Rule::abscissa()[n]);
      const auto weight = static_cast<double>(Rule::weights()[n]);
      add(middle - half * place, half * weight);
      add(middle + half * place, half * weight);
    }
  }
  return nodes;
}

/// Returns the distance from a source to its nearest image [length]. Spheres that do not overlap their images
/// have at most this diameter.
double nearest_image(const PeriodicLine& line) {
  double nearest = line.period;
  for (const auto& axis : {line.y, line.z}) {
    nearest = std::min(nearest, axis.period);
    if (axis.mirror > 0) nearest = std::min({nearest, axis.mirror, axis.period - axis.mirror});
  }
  return nearest;
}

struct Place {
  double x, rho2;
};

double nearest_distance(const std::vector<Place>& places) {
  double r2 = places.front().x * places.front().x + places.front().rho2;
  for (const auto& place : places) r2 = std::min(r2, place.x * place.x + place.rho2);
  return std::sqrt(r2);
}

}  // namespace

PeriodicUnsteadyStokes::PeriodicUnsteadyStokes(const PeriodicStokes& steady, Complex alpha)
    : steady_(steady), alpha_(alpha) {
  const auto& line = steady.line();
  if (decays_within_box()) {
    // Flow below e^-40 = 4e-18 of the flow at the surface of the largest sphere is neglected.
    constexpr double decay_length = 40;
    cutoff_ = decay_length / alpha.real() + nearest_image(line);
    image_lines_ = image_lines(line, cutoff_);
    return;
  }
  cutoff_ = image_cutoff(line.splitting);
  image_lines_ = image_lines(line, cutoff_);
  const double longest = max_wavenumber(line.splitting), spacing = 2 * pi / line.period;
  const double tau = 1 / (4 * line.splitting * line.splitting);
  const Complex alpha2 = alpha * alpha, decay = std::exp(-alpha2 * tau),
                growth = tau * mean_decay(alpha2 * tau);
  const auto waves = transverse_waves(line, longest);
  for (int n = 0; n * spacing < longest; ++n) {
    const double kx2 = n * spacing * n * spacing;
    const double scale = (n == 0 ? 1 : 2) / (steady.viscosity() * line.volume());
    const auto sum = transverse_sum(waves, n * spacing, alpha2, line.splitting);
    wave_sums_.push_back({scale * decay * (1.0 + kx2 / alpha2) * sum.heat_sum,
                          scale * ((decay - kx2 * growth) * sum.heat_sum - kx2 * sum.steady_sum)});
  }
}

/// Returns true if |alpha| V^{1/3} > 13, where V is the volume of the box. The unsteady flow of an image then
/// decays within the box. The splitting parameter is xi = 6/V^{1/3}.
bool PeriodicUnsteadyStokes::decays_within_box() const {
  return std::abs(alpha_) > 13.0 / 6 * steady_.line().splitting;
}

PeriodicUnsteadyStokes::Parts PeriodicUnsteadyStokes::waves(double displacement) const {
  const double spacing = 2 * pi / steady_.line().period;
  const Complex step = std::polar(1.0, spacing * displacement);
  Complex phase = 1;
  Parts sum;
  double k = 0;
  for (const auto& wave : wave_sums_) {
    const LineValue<double> shape{phase.real(), -k * phase.imag()};
    sum.helmholtz += wave.helmholtz * shape;
    sum.total += wave.total * shape;
    phase *= step;
    k += spacing;
  }
  return sum;
}

PeriodicUnsteadyStokes::Parts PeriodicUnsteadyStokes::near_images(double displacement) const {
  const auto& line = steady_.line();
  std::vector<Place> places;
  for_each_image(line.period, image_lines_, cutoff_, displacement, [&](double x, double rho2) {
    places.push_back({x, rho2});
  });
  Parts sum;
  if (places.empty()) return sum;
  for (const auto& node : heat_nodes(line.splitting, alpha_, nearest_distance(places))) {
    const double p2 = node.p * node.p;
    LineValue<double> plain, curved;  // sums over images of e^{-p^2 r^2} and of its second derivative
    for (const auto& [x, rho2] : places) {
      // clang-format off
      const double g = std::exp(-p2 * (x * x + rho2)), px2 = p2 * x * x;
      plain  += LineValue<double>{                       g,        -2 * p2 * x                 * g};
      curved += LineValue<double>{2 * p2 * (2 * px2 - 1) * g, 4 * p2 * p2 * x * (3 - 2 * px2) * g};
      // clang-format on
    }
    sum.helmholtz += node.plain * plain;
    sum.helmholtz += node.helmholtz_curved * curved;
    sum.total += node.plain * plain;
    sum.total += node.total_curved * curved;
  }
  const double scale = 1 / steady_.viscosity();
  return {scale * sum.helmholtz, scale * sum.total};
}

/// Evaluates the flow of the source itself that the sum over wavevectors contains: the integral over s > tau
/// at r = 0, with tau = 1/(4 xi^2). It follows from
///
///   I = integral_0^xi e^{-alpha^2/(4 p^2)} dp = xi e^{-alpha^2 tau} - (alpha/2) sqrt(pi) erfc(alpha/(2 xi))
PeriodicUnsteadyStokes::Parts PeriodicUnsteadyStokes::self_flow_of_waves() const {
  const double xi = steady_.line().splitting, tau = 1 / (4 * xi * xi);
  const Complex alpha2 = alpha_ * alpha_, decay = std::exp(-alpha2 * tau);
  const Complex integral =
      xi * decay - alpha_ / 2.0 * std::sqrt(pi) * complementary_error_function(alpha_ / (2 * xi));
  const double scale = 1 / (3 * std::pow(pi, 1.5) * steady_.viscosity());
  const double xi3 = xi * xi * xi;
  // clang-format off
  return {.helmholtz = {scale * (integral + xi3 * decay / alpha2), 0},
          .total     = {scale * (integral - xi3 * tau * mean_decay(alpha2 * tau)), 0}};
  // clang-format on
}

PeriodicUnsteadyStokes::Parts PeriodicUnsteadyStokes::ewald_sum(double displacement) const {
  Parts parts = waves(displacement);
  const Parts images = near_images(displacement);
  parts.helmholtz += images.helmholtz;
  parts.total += images.total;
  return parts;
}

LineValue<Complex> PeriodicUnsteadyStokes::helmholtz_images(double displacement) const {
  LineValue<Complex> sum;
  for_each_image(steady_.line().period, image_lines_, cutoff_, displacement, [&](double x, double rho2) {
    sum += unsteady_stokeslet(steady_.viscosity(), alpha_, x, rho2).helmholtz;
  });
  return sum;
}

LineValue<Complex> PeriodicUnsteadyStokes::harmonic(const LineValue<double>& steady_laplacian) const {
  const double neutral = steady_.line().copies() / (steady_.viscosity() * steady_.line().volume());
  const Complex alpha2 = alpha_ * alpha_;
  return {(neutral - 6 * steady_laplacian.value) / alpha2, -6 * steady_laplacian.slope / alpha2};
}

UnsteadyLine PeriodicUnsteadyStokes::flow(double displacement,
                                          const LineValue<double>& steady_laplacian) const {
  const auto potential = harmonic(steady_laplacian);
  if (decays_within_box()) {
    const auto decaying = helmholtz_images(displacement);
    auto total = decaying;
    total += potential;
    return {.helmholtz = decaying, .harmonic = potential, .total = total};
  }
  const Parts parts = ewald_sum(displacement);
  return {.helmholtz = parts.helmholtz, .harmonic = potential, .total = parts.total};
}

UnsteadyLine PeriodicUnsteadyStokes::at(double displacement) const {
  return flow(displacement, steady_.at(displacement).laplacian);
}

UnsteadyLine PeriodicUnsteadyStokes::images() const {
  UnsteadyLine images = flow(0, steady_.images().laplacian);
  if (decays_within_box()) return images;
  const Parts own = self_flow_of_waves();
  images.helmholtz += -1.0 * own.helmholtz;
  images.total += -1.0 * own.total;
  return images;
}

}  // namespace beadswim
