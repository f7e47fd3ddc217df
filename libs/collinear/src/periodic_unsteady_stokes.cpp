#include "beadswim/collinear/unsteady_stokes.hpp"
#include "beadswim/core/gauss_legendre.hpp"
#include "periodic_flow.hpp"

// clang-format off
// Unsteady Stokes flow of a periodic lattice of oscillating forces along x: velocity along x on the line of
// the forces, per force. alpha^2 = i omega rho / eta. The flow and its two parts have these Fourier
// transforms:
//
//   helmholtz  (1/eta) (1 + k_x^2/alpha^2) / (k^2 + alpha^2)    with k = 0: 1/(eta alpha^2 V), uniform flow
//   harmonic   (1/eta) ( -  k_x^2/alpha^2) /  k^2               without k = 0
//   total      (1/eta) (1 - k_x^2/k^2)     / (k^2 + alpha^2)    with k = 0
//
// The harmonic part follows from the steady velocity per force, G_xx (periodic_stokes.cpp). With n copies of
// the force in the lattice cell of volume V:
//
//   eta alpha^2 harmonic = n/V - eta laplacian of the steady G_xx
//
// The helmholtz part and the total are evaluated as Ewald sums of the integrals
//
//   helmholtz  (1/eta) integral_0^oo [ e^{-alpha^2 s} g_s - (e^{-alpha^2 s}/alpha^2) d^2 g_s/dx^2 ] ds
//   total      (1/eta) integral_0^oo [ e^{-alpha^2 s} g_s +                    q(s)  d^2 g_s/dx^2 ] ds
//
//   g_s(r) = (4 pi s)^{-3/2} exp(-r^2/4s), the heat kernel;   q(s) = (1 - e^{-alpha^2 s})/alpha^2;   tau = 1/(4 xi^2)
// clang-format on
//
// The integrals over s > tau are evaluated as sums over wavevectors. The integrals over s < tau are evaluated
// as sums over images, with Gauss-Legendre quadrature in s. No term is larger than the sum, so the total
// suffers no loss of significance as alpha -> 0. If |alpha| V_box^{1/3} > 13, where V_box is the volume of
// the box, the helmholtz flow of an image decays within the box. The helmholtz part is then summed directly
// over images.

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

/// Quadrature node of the integrals over s < tau that give the sums over images. s = 1/(4 p^2). The weights
/// are factors of exp(-p^2 r^2) and of its second derivative along x.
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
  static const std::vector<QuadratureNode> rule = gauss_legendre(16, 0, 1);
  std::vector<HeatNode> nodes;
  for (int panel = 0; panel < panels; ++panel) {
    for (const auto& [place, weight] : rule) {
      const double p = xi * std::exp(span * (panel + place) / panels), s = 1 / (4 * p * p);
      const double scale = weight * span / panels * p / (2 * std::pow(pi, 1.5));
      const Complex decay = scale * std::exp(-alpha2 * s);
      nodes.push_back({.p = p,
                       .plain = decay,
                       .helmholtz_curved = -decay / alpha2,
                       .total_curved = scale * s * mean_decay(alpha2 * s)});
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
  // Flow below e^-40 = 4e-18 of the flow at the surface of the largest sphere is neglected.
  constexpr double decay_length = 40;
  cutoff_ = decays_within_box() ? decay_length / alpha.real() + nearest_image(line) : line.image_cutoff();
  image_lines_ = image_lines(line, cutoff_);
  if (decays_within_box()) return;
  const double tau = 1 / (4 * line.splitting * line.splitting);
  const Complex alpha2 = alpha * alpha, decay = std::exp(-alpha2 * tau),
                growth = tau * mean_decay(alpha2 * tau);
  // The terms are e^(-k^2 tau)/(k^2 + alpha^2), and the same divided by k^2 without k = 0.
  waves_ =
      sum_over_transverse_waves<Complex>(line, [&](auto& sum, const PeriodicLine::Wave& wave, double k2) {
        const Complex term = wave.weight * std::exp(-k2 * tau) / (k2 + alpha2);
        sum[0] += term;
        if (k2 > 0) sum[1] += term / k2;
      });
  for (std::size_t n = 0; n < waves_.size(); ++n) {
    const double kx2 = n * line.wave_spacing() * n * line.wave_spacing();
    const double scale = (n == 0 ? 1 : 2) / (steady.viscosity() * line.volume());
    const auto [heat_sum, steady_sum] = waves_[n];
    waves_[n] = {scale * decay * (1.0 + kx2 / alpha2) * heat_sum,
                 scale * ((decay - kx2 * growth) * heat_sum - kx2 * steady_sum)};
  }
}

/// Returns true if |alpha| V^{1/3} > 13, where V is the volume of the box. The unsteady flow of an image then
/// decays within the box. The splitting parameter is xi = 6/V^{1/3}.
bool PeriodicUnsteadyStokes::decays_within_box() const {
  return std::abs(alpha_) > 13.0 / 6 * steady_.line().splitting;
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
    LineKernel<double> plain, curved;  // sums over images of e^{-p^2 r^2} and of its second derivative
    for (const auto& [x, rho2] : places) {
      // clang-format off
      const double g = std::exp(-p2 * (x * x + rho2)), px2 = p2 * x * x;
      plain  += displacement_kernel(                       g,        -2 * p2 * x                 * g);
      curved += displacement_kernel(2 * p2 * (2 * px2 - 1) * g, 4 * p2 * p2 * x * (3 - 2 * px2) * g);
      // clang-format on
    }
    for (auto& part : sum) part += node.plain * plain;
    sum[0] += node.helmholtz_curved * curved;
    sum[1] += node.total_curved * curved;
  }
  const double scale = 1 / steady_.viscosity();
  return {scale * sum[0], scale * sum[1]};
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
  return {LineKernel<Complex>{.value = scale * (integral + xi3 * decay / alpha2)},
          LineKernel<Complex>{.value = scale * (integral - xi3 * tau * mean_decay(alpha2 * tau))}};
}

LineKernel<Complex> PeriodicUnsteadyStokes::helmholtz_images(double displacement) const {
  LineKernel<Complex> sum;
  for_each_image(steady_.line().period, image_lines_, cutoff_, displacement, [&](double x, double rho2) {
    sum += unsteady_stokeslet(steady_.viscosity(), alpha_, x, rho2).helmholtz;
  });
  return sum;
}

UnsteadyFlow PeriodicUnsteadyStokes::flow(double displacement,
                                          const LineKernel<double>& steady_laplacian) const {
  const PeriodicLine& line = steady_.line();
  const double neutral = line.copies() / (steady_.viscosity() * line.volume());
  const Complex alpha2 = alpha_ * alpha_;
  const auto harmonic = displacement_kernel((neutral - 6 * steady_laplacian.value) / alpha2,
                                            -6 * steady_laplacian.by_receiver / alpha2);
  if (decays_within_box()) {
    const auto helmholtz = helmholtz_images(displacement);
    auto total = helmholtz;
    total += harmonic;
    return {.helmholtz = helmholtz, .harmonic = harmonic, .total = total};
  }
  auto [helmholtz, total] = sum_over_waves(waves_, line, displacement);
  const auto near = near_images(displacement);
  helmholtz += near[0];
  total += near[1];
  return {.helmholtz = helmholtz, .harmonic = harmonic, .total = total};
}

UnsteadyFlow PeriodicUnsteadyStokes::at(double displacement) const {
  return flow(displacement, steady_.at(displacement).laplacian);
}

UnsteadyFlow PeriodicUnsteadyStokes::images() const {
  UnsteadyFlow images = flow(0, steady_.images().laplacian);
  if (decays_within_box()) return images;
  const Parts own = self_flow_of_waves();
  images.helmholtz += -1.0 * own[0];
  images.total += -1.0 * own[1];
  return images;
}

}  // namespace beadswim
