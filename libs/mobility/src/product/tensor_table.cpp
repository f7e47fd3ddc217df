#include "tensor_table.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

namespace beadswim {
namespace {

constexpr int powers = PairTable::degree + 1;

/// Values at the Chebyshev points of [0, 1], or coefficients of the polynomial of degree 5 through these
/// values.
using Fit = Eigen::Matrix<double, powers, 1>;

double chebyshev_point(int k) {
  return 0.5 - 0.5 * std::cos(std::numbers::pi * (k + 0.5) / powers);
}

/// Returns the coefficients of the polynomial of degree 5 that has the given values at the Chebyshev points.
Fit fit(const Fit& values) {
  static const Eigen::Matrix<double, powers, powers> inverse = [] {
    Eigen::Matrix<double, powers, powers> at_points;
    for (int k = 0; k < powers; ++k)
      for (int p = 0; p < powers; ++p) at_points(k, p) = std::pow(chebyshev_point(k), p);
    return Eigen::Matrix<double, powers, powers>(at_points.inverse());
  }();
  return inverse * values;
}

}  // namespace

PairTensor near_part(const std::optional<EwaldSplit>& split, bool is_positive, double a_i, double a_j,
                     double r, double viscosity) {
  if (!split) return rotne_prager_tensor(a_i, a_j, r, viscosity);
  const double squares = a_i * a_i + a_j * a_j;
  const PairSizes sizes{.squares = squares, .product = is_positive ? a_i * a_i * a_j * a_j : 0};
  if (r < 1e-3 * std::min(a_i, a_j))  // avoids cancellation of large terms as r -> 0
    return rotne_prager_tensor(a_i, a_j, r, viscosity) -
           far_tensor(*split, 0, viscosity).sphere_tensor(sizes);
  PairTensor tensor = near_tensor(*split, r, viscosity).sphere_tensor(sizes);
  if (r < a_i + a_j) {
    const PairTensor overlap =
        rotne_prager_tensor(a_i, a_j, r, viscosity) - rotne_prager_tensor_apart(squares, r, viscosity);
    tensor = {tensor.isotropic + overlap.isotropic, tensor.axial + overlap.axial};
  }
  return tensor;
}

TensorTable::TensorTable(const ImagedSpheres& spheres, const EwaldPlan& plan, double min_distance) {
  const auto [smallest, largest] = std::ranges::minmax_element(spheres.radii);
  const bool has_one_radius = *smallest == *largest;
  const double first_distance = std::min(min_distance, plan.cutoff), square = *largest * *largest;
  const PairSizes sizes{.squares = 2 * square, .product = plan.is_positive ? square * square : 0};
  const EwaldSplit split(plan.cutoff, plan.shape);
  min_square_ = first_distance * first_distance;
  const auto stretch_of = [](double r) { return std::bit_cast<std::int64_t>(r * r) >> PairTable::shift; };
  table_ = {.first = stretch_of(first_distance),
            .functions = has_one_radius     ? 2
                         : plan.is_positive ? 6
                                            : 4,
            .coefficients = nullptr};
  const auto stretches = static_cast<int>(stretch_of(plan.cutoff) - table_.first);
  coefficients_.resize(static_cast<std::size_t>(stretches + 1) * powers * table_.functions);
  for (int s = 0; s <= stretches; ++s) {
    std::array<Fit, 6> values;
    const auto edge = [&](int n) { return std::bit_cast<double>((table_.first + n) << PairTable::shift); };
    for (int k = 0; k < powers; ++k) {
      const double r = std::sqrt(std::lerp(edge(s), edge(s + 1), chebyshev_point(k)));
      const SplitTensor parts = near_tensor(split, r, spheres.viscosity);
      const PairTensor first = has_one_radius ? parts.sphere_tensor(sizes) : parts.oseen;
      values[0][k] = first.isotropic;
      values[1][k] = first.axial / (r * r);
      values[2][k] = parts.laplacian.isotropic / 6;
      values[3][k] = parts.laplacian.axial / 6 / (r * r);
      values[4][k] = parts.bilaplacian.isotropic / 36;
      values[5][k] = parts.bilaplacian.axial / 36 / (r * r);
    }
    for (int f = 0; f < table_.functions; ++f) {
      const Fit coefficients = fit(values[f]);
      for (int p = 0; p < powers; ++p)
        coefficients_[(static_cast<std::size_t>(s) * powers + p) * table_.functions + f] = coefficients[p];
    }
  }
  table_.coefficients = coefficients_.data();
}

}  // namespace beadswim
