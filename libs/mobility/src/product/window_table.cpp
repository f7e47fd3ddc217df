#include "window_table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "ewald_split.hpp"

namespace beadswim {
namespace {

constexpr int nodes = 40;

/// Coefficients of T_0 to T_39.
using Chebyshev = std::array<double, nodes>;

/// Returns the Chebyshev coefficients of a function on [-1, 1].
template <class Function>
Chebyshev chebyshev(const Function& function) {
  Chebyshev coefficients{};
  for (int j = 0; j < nodes; ++j) {
    const double angle = std::numbers::pi * (j + 0.5) / nodes, value = function(std::cos(angle));
    for (int n = 0; n < nodes; ++n) coefficients[n] += (n == 0 ? 1.0 : 2.0) / nodes * value * std::cos(n * angle);
  }
  return coefficients;
}

/// Returns the same sum of T_0 to T_degree by powers.
std::vector<double> by_powers(const Chebyshev& coefficients, int degree) {
  std::vector<double> sum(degree + 1, 0.0), below(degree + 1, 0.0), here(degree + 1, 0.0);
  here[0] = 1;  // T_0
  for (int n = 0; n <= degree; ++n) {
    for (int p = 0; p <= n; ++p) sum[p] += coefficients[n] * here[p];
    std::vector<double> next(degree + 1, 0.0);  // T_(n+1) = 2 x T_n - T_(n-1)
    for (int p = 0; p < degree; ++p) next[p + 1] = (n == 0 ? 1 : 2) * here[p];
    for (int p = 0; p <= degree && n > 0; ++p) next[p] -= below[p];
    below = std::exchange(here, std::move(next));
  }
  return sum;
}

}  // namespace

WindowTable::WindowTable(int points, double shape) : points_(points), shape_(shape) {
  const double height = 1 / (points * sinh_ratio(shape * shape)), middle = points / 2.0;
  std::vector<Chebyshev> at_points;
  for (int p = 0; p < points; ++p)
    at_points.push_back(chebyshev([&](double place) {
      return height * kaiser_bessel_bell(shape, (p - middle + (place + 1) / 2) / middle);
    }));
  // The truncated polynomials add less than the truncated window.
  const double negligible = 1e-3 * height;
  for (const Chebyshev& coefficients : at_points)
    for (int n = 0; n < nodes; ++n)
      if (std::abs(coefficients[n]) > negligible) degree_ = std::max(degree_, n);
  const int padded = (points + 3) / 4 * 4;
  polynomials_.assign(std::size_t(highest_derivative + 1) * (degree_ + 1) * padded, 0.0);
  for (int p = 0; p < points; ++p) {
    std::vector<double> powers = by_powers(at_points[p], degree_);
    for (int k = 0; k <= highest_derivative; ++k) {
      for (int power = 0; power <= degree_; ++power) {
        polynomials_[(std::size_t(k) * (degree_ + 1) + power) * padded + p] = powers[power];
        // The derivative by x is twice that by the variable.
        powers[power] = power < degree_ ? 2 * (power + 1) * powers[power + 1] : 0;
      }
    }
  }
}

double WindowTable::transform(double k) const {
  const double waves = k * points_ / 2;
  return sinh_ratio(shape_ * shape_ - waves * waves) / sinh_ratio(shape_ * shape_);
}

}  // namespace beadswim
