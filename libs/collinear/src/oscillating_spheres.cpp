#include "beadswim/collinear/oscillating_spheres.hpp"

#include <Eigen/QR>
#include <cmath>
#include <numbers>

#include "beadswim/core/complex.hpp"
#include "beadswim/core/gauss_legendre.hpp"

namespace beadswim {

namespace {

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

/// Factors of degree n of both series at a point. The first series has u_r = first_r value and
/// u_theta = first_theta slope, the second u_r = second_r value and u_theta = second_theta slope.
struct Degree {
  double first_r, first_theta;  ///< proportional to r^-(n+2)
  Complex second_r, second_theta;
  Complex second_r_change, second_theta_change;  ///< derivatives of second_r and second_theta by log r
  double value, slope, curvature;                ///< P_n(cos theta) and its first two derivatives by theta
};

/// Calls use(n, degree) for n = 1 .. order, at a point around a sphere.
template <typename Use>
void for_each_degree(double radius, Complex alpha, int order, const Polar& place, const Use& use) {
  const auto [r, cosine, sine] = place;
  const Complex x = alpha * r, kappa = alpha * radius;
  const bool is_viscous = has_viscous_series(kappa);
  const Complex decay = is_viscous ? std::exp(-x) : std::exp(kappa - x);
  Complex g_two_below = 0, g_below = decay, g = (1.0 + x) * decay;  // g_(n-2), g_(n-1) and g_n
  Complex h = is_viscous ? first_h(x) : 0;
  double below = 1, value = cosine, derivative = 1;  // P_(n-1), P_n and dP_n/dcos(theta)
  const double q = radius / r;
  double power = q;  // q^n
  for (int n = 1; n <= order; ++n, power *= q) {
    if (!is_viscous) h = -2.0 * (2 * n - 1) * g / (x * x);
    const Complex g_below_slope = n == 1 ? -x * decay : -x * x * g_two_below / (2.0 * n - 3);  // x g_(n-1)'
    const double steeper = power * q * q;                                                      // q^(n+2)
    // clang-format off
    use(n, Degree{.first_r = -(n + 1) * steeper,
                  .first_theta = steeper,
                  .second_r = n * (n + 1) * power * h,
                  .second_theta = power * (2.0 * g_below - double(n) * h),
                  .second_r_change = n * (n + 1) * power * (2.0 * g_below - (n + 2.0) * h),
                  .second_theta_change = power * (-4.0 * n * g_below + n * (n + 2.0) * h + 2.0 * g_below_slope),
                  .value = value,
                  .slope = -sine * derivative,
                  .curvature = -n * (n + 1) * value + cosine * derivative});
    // clang-format on
    if (is_viscous) h = ((2.0 * n + 1) * h - 2.0 * g_below) / (2.0 * n - 1);
    const Complex g_above = g + x * x * g_below / ((2.0 * n + 1) * (2.0 * n - 1));
    g_two_below = g_below;
    g_below = g;
    g = g_above;
    const double next = ((2 * n + 1) * cosine * value - n * below) / (n + 1);
    derivative = (n + 1) * value + cosine * derivative;
    below = value;
    value = next;
  }
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
        const Polar place =
            i == j ? Polar{radius_[i], cosine, sine}
                   : polar_of(position_[i] - position_[j] + radius_[i] * cosine, radius_[i] * sine);
        const Eigen::Matrix2d axes = root * axes_of(place);
        for_each_degree(radius_[j], alpha, order, place, [&](int n, const Degree& degree) {
          const int first = 2 * order * j + n - 1;
          const auto set = [&](int column, Complex u_r, Complex u_theta) {
            matrix.block<2, 1>(row, column) =
                axes * Eigen::Vector2cd(u_r * degree.value, u_theta * degree.slope);
          };
          set(first, degree.first_r, degree.first_theta);
          set(first + order, degree.second_r, degree.second_theta);
        });
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
  Eigen::Matrix2Xcd sum = Eigen::Matrix2Xcd::Zero(2, count()), own(2, count());
  for (int j = 0; j < count(); ++j) {
    const Polar place = polar_of(x - position_[j], s);
    own.setZero();
    for_each_degree(radius_[j], alpha_, order_, place, [&](int n, const Degree& degree) {
      for (int k = 0; k < count(); ++k) {
        const auto [first, second] = coefficients_of(j, n, k);
        own(0, k) += degree.value * (degree.first_r * first + degree.second_r * second);
        own(1, k) += degree.slope * (degree.first_theta * first + degree.second_theta * second);
      }
    });
    sum += axes_of(place) * own;
  }
  return sum;
}

FlowAtPoint OscillatingSpheres::at(double x, double s) const {
  FlowAtPoint flow{.velocity = Eigen::Matrix2Xcd::Zero(2, count()), .gradient = {}};
  flow.gradient.setZero(4, count());
  // Rows: u_r, u_theta, r du_r/dr, r du_theta/dr, du_r/dtheta, du_theta/dtheta.
  Eigen::Matrix<Complex, 6, Eigen::Dynamic> own(6, count());
  for (int j = 0; j < count(); ++j) {
    const Polar place = polar_of(x - position_[j], s);
    own.setZero();
    for_each_degree(radius_[j], alpha_, order_, place, [&](int n, const Degree& degree) {
      for (int k = 0; k < count(); ++k) {
        const auto [first, second] = coefficients_of(j, n, k);
        const Complex first_r = degree.first_r * first, first_theta = degree.first_theta * first;
        const Complex u_r = first_r + degree.second_r * second;
        const Complex u_theta = first_theta + degree.second_theta * second;
        own(0, k) += degree.value * u_r;
        own(1, k) += degree.slope * u_theta;
        own(2, k) += degree.value * (degree.second_r_change * second - (n + 2.0) * first_r);
        own(3, k) += degree.slope * (degree.second_theta_change * second - (n + 2.0) * first_theta);
        own(4, k) += degree.slope * u_r;
        own(5, k) += degree.curvature * u_theta;
      }
    });
    const Eigen::Matrix2d axes = axes_of(place);
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
