#include "beadswim/mobility/oscillating_spheres.hpp"

#include <Eigen/QR>
#include <cmath>
#include <numbers>

#include "beadswim/mobility/gauss_legendre.hpp"

namespace beadswim {

namespace {

using Complex = std::complex<double>;

/// Legendre polynomial P_n of cos(theta) and its first two derivatives by theta, for n = 1 .. order.
struct Legendre {
  Eigen::ArrayXd value, slope, curvature;
};

Legendre legendre_of(double cosine, double sine, int order) {
  Legendre p{
      .value = Eigen::ArrayXd(order), .slope = Eigen::ArrayXd(order), .curvature = Eigen::ArrayXd(order)};
  double below = 1, value = cosine, derivative = 1;  // P_(n-1), P_n and dP_n/dcos(theta)
  for (int n = 1; n <= order; ++n) {
    p.value[n - 1] = value;
    p.slope[n - 1] = -sine * derivative;
    p.curvature[n - 1] = -n * (n + 1) * value + cosine * derivative;
    const double next = ((2 * n + 1) * cosine * value - n * below) / (n + 1);
    derivative = (n + 1) * value + cosine * derivative;
    below = value;
    value = next;
  }
  return p;
}

/// Radial functions of the second series, for n = 1 .. order: h_n, g_(n-1) and x g_(n-1)'.
struct Radial {
  Eigen::ArrayXcd h, g_below, g_below_slope;
};

/// Returns h_1 = 2 (1 - (1 + x) e^-x)/x^2.
Complex first_h(Complex x) {
  if (std::abs(x) > 1) return 2.0 * (1.0 - (1.0 + x) * std::exp(-x)) / (x * x);
  Complex power = 1, sum = 0;
  double factorial = 2;
  for (int k = 2; k <= 22; ++k) {  // 2 (k-1) (-x)^(k-2) / k!
    sum += 2.0 * (k - 1) / factorial * power;
    power *= -x;
    factorial *= k + 1;
  }
  return sum;
}

/// Returns whether the second series of a sphere with kappa = alpha a is viscous; otherwise it is rotational.
bool has_viscous_series(Complex kappa) {
  return std::abs(kappa) < 4;
}

/// Returns the radial functions of the second series at r, for a sphere of radius a.
Radial radial_of(double radius, Complex alpha, double r, int order) {
  const Complex x = alpha * r, kappa = alpha * radius;
  const bool is_viscous = has_viscous_series(kappa);
  const Complex decay = is_viscous ? std::exp(-x) : std::exp(kappa - x);
  Radial v{.h = Eigen::ArrayXcd(order),
           .g_below = Eigen::ArrayXcd(order),
           .g_below_slope = Eigen::ArrayXcd(order)};
  Complex g_two_below = 0, g_below = decay, g = (1.0 + x) * decay;  // g_(n-2), g_(n-1) and g_n
  Complex h = is_viscous ? first_h(x) : 0;
  for (int n = 1; n <= order; ++n) {
    if (!is_viscous) h = -2.0 * (2 * n - 1) * g / (x * x);
    v.h[n - 1] = h;
    v.g_below[n - 1] = g_below;
    v.g_below_slope[n - 1] = n == 1 ? -x * decay : -x * x * g_two_below / (2.0 * n - 3);
    if (is_viscous) h = ((2.0 * n + 1) * h - 2.0 * g_below) / (2.0 * n - 1);
    const Complex g_above = g + x * x * g_below / ((2.0 * n + 1) * (2.0 * n - 1));
    g_two_below = g_below;
    g_below = g;
    g = g_above;
  }
  return v;
}

/// Multipoles of one sphere at a point in polar coordinates. Rows: u_r, u_theta, r du_r/dr, r du_theta/dr,
/// du_r/dtheta, du_theta/dtheta. Columns: the first series, then the second.
using Multipoles = Eigen::Matrix<Complex, 6, Eigen::Dynamic>;

Multipoles multipoles_of(double radius, Complex alpha, int order, double r, double cosine, double sine) {
  const Legendre p = legendre_of(cosine, sine, order);
  const Radial v = radial_of(radius, alpha, r, order);
  const double q = radius / r;
  Multipoles m(6, 2 * order);
  double power = q;  // q^n
  for (int k = 0; k < order; ++k, power *= q) {
    const int n = k + 1;
    const double steeper = power * q * q;  // q^(n+2)
    // clang-format off
    const double  first_r     = -(n + 1) * steeper;
    const double  first_theta = steeper;
    const Complex second_r        = n * (n + 1) * power * v.h[k];
    const Complex second_theta    = power * (2.0 * v.g_below[k] - double(n) * v.h[k]);
    const Complex slope_r         = n * (n + 1) * power * (2.0 * v.g_below[k] - (n + 2.0) * v.h[k]);
    const Complex slope_theta     = power * (-4.0 * n * v.g_below[k] + n * (n + 2.0) * v.h[k] + 2.0 * v.g_below_slope[k]);
    m.col(k)         << first_r * p.value[k], first_theta * p.slope[k],
                        -(n + 2) * first_r * p.value[k], -(n + 2) * first_theta * p.slope[k],
                        first_r * p.slope[k], first_theta * p.curvature[k];
    m.col(order + k) << second_r  * p.value[k], second_theta  * p.slope[k],
                        slope_r * p.value[k], slope_theta * p.slope[k],
                        second_r  * p.slope[k], second_theta  * p.curvature[k];
    // clang-format on
  }
  return m;
}

/// A point in polar coordinates around the centre of a sphere: distance [length], cosine and sine of theta.
struct Polar {
  double r, cosine, sine;
};

Polar polar_of(double x, double s) {
  const double r = std::hypot(x, s);
  return {.r = r, .cosine = x / r, .sine = s / r};
}

/// Returns the matrix whose columns are the unit vectors of r and theta, in components along x and s.
Eigen::Matrix2d axes_of(const Polar& place) {
  Eigen::Matrix2d axes;
  axes << place.cosine, -place.sine, place.sine, place.cosine;
  return axes;
}

}  // namespace

OscillatingSpheres::OscillatingSpheres(std::span<const double> radii, std::span<const double> positions,
                                       double viscosity, Complex alpha, int order)
    : radius_(radii.begin(), radii.end()),
      position_(positions.begin(), positions.end()),
      alpha_(alpha),
      order_(order) {
  const int spheres = count(), unknowns = 2 * order * spheres;
  const std::vector<QuadratureNode> nodes = gauss_legendre(2 * order + 4, -1, 1);
  const int rows = 2 * static_cast<int>(nodes.size());  // of one sphere
  Eigen::MatrixXcd matrix(rows * spheres, unknowns), motion = Eigen::MatrixXcd::Zero(rows * spheres, spheres);
  for (int i = 0; i < spheres; ++i) {
    int row = rows * i;
    for (const auto& [cosine, weight] : nodes) {
      const double root = std::sqrt(weight), sine = std::sqrt(1 - cosine * cosine);
      motion(row, i) = root;
      for (int j = 0; j < spheres; ++j) {
        const auto [r, c, s] =
            i == j ? Polar{radius_[i], cosine, sine}
                   : polar_of(position_[i] - position_[j] + radius_[i] * cosine, radius_[i] * sine);
        const Multipoles m = multipoles_of(radius_[j], alpha, order, r, c, s);
        matrix.block(row, 2 * order * j, 1, 2 * order) = root * (c * m.row(0) - s * m.row(1));
        matrix.block(row + 1, 2 * order * j, 1, 2 * order) = root * (s * m.row(0) + c * m.row(1));
      }
      row += 2;
    }
  }
  coefficients_ = matrix.householderQr().solve(motion);

  resistance_.resize(spheres, spheres);
  for (int j = 0; j < spheres; ++j) {
    const double a = radius_[j], scale = 4 * std::numbers::pi * viscosity * a;
    const Complex kappa = alpha * a;
    resistance_.row(j) = -scale * kappa * kappa * coefficients_.row(2 * j * order);
    if (has_viscous_series(kappa)) resistance_.row(j) += 2 * scale * coefficients_.row((2 * j + 1) * order);
    resistance_(j, j) -= scale * kappa * kappa / 3.0;
  }
}

Eigen::Matrix2Xcd OscillatingSpheres::velocity(double x, double s) const {
  Eigen::Matrix2Xcd sum = Eigen::Matrix2Xcd::Zero(2, count());
  for (int j = 0; j < count(); ++j) {
    const Polar place = polar_of(x - position_[j], s);
    const Multipoles m = multipoles_of(radius_[j], alpha_, order_, place.r, place.cosine, place.sine);
    sum += axes_of(place).cast<Complex>() * (m.topRows(2) * own_coefficients(j));
  }
  return sum;
}

FlowAtPoint OscillatingSpheres::at(double x, double s) const {
  FlowAtPoint flow{.velocity = Eigen::Matrix2Xcd::Zero(2, count()), .gradient = {}};
  flow.gradient.setZero(4, count());
  for (int j = 0; j < count(); ++j) {
    const Polar place = polar_of(x - position_[j], s);
    const Multipoles own =
        multipoles_of(radius_[j], alpha_, order_, place.r, place.cosine, place.sine) * own_coefficients(j);
    const Eigen::Matrix2cd axes = axes_of(place).cast<Complex>();
    flow.velocity += axes * own.topRows(2);
    for (int k = 0; k < count(); ++k) {
      Eigen::Matrix2cd polar;  // row: direction of the derivative; column: component
      polar << own(2, k), own(3, k), own(4, k) - own(1, k), own(5, k) + own(0, k);
      const Eigen::Matrix2cd gradient = axes * polar * axes.transpose() / place.r;
      flow.gradient.col(k) += gradient.transpose().reshaped();
    }
  }
  return flow;
}

Eigen::RowVectorXcd OscillatingSpheres::surface_shear(int sphere, double cosine) const {
  const double sine = std::sqrt(1 - cosine * cosine), a = radius_[sphere];
  const FlowAtPoint flow = at(position_[sphere] + a * cosine, a * sine);
  const Eigen::RowVector4d normal_to_theta(-cosine * sine, cosine * cosine, -sine * sine, sine * cosine);
  return normal_to_theta.cast<Complex>() * flow.gradient;
}

}  // namespace beadswim
