#include "beadswim/mobility/wall_map.hpp"

#include <cmath>

namespace beadswim {
namespace {

constexpr double smallest_gap = 1e-4, largest_gap = 63;  // of the table [radius]

LazyTable<1, 1>::Axis axis_of_gaps() {
  const double first = std::log(smallest_gap), last = std::log(largest_gap);
  return {.first = first,
          .nodes = static_cast<int>(std::ceil((last - first) / LazyTable<1, 1>::spacing)) + 1};
}

}  // namespace

// With cosh(alpha) = height and k = 2 n + 1:
//
//   D = 4/3 sinh(alpha) sum_n n (n + 1)/((2 n - 1)(2 n + 3)) (N_n - 1),    n = 1, 2, ...
//   N_n = (2 sinh(k alpha) + k sinh(2 alpha))/(4 sinh^2(k alpha/2) - k^2 sinh^2(alpha))
double drag_towards_wall(double height) {
  const double alpha = std::acosh(height), sinh_alpha = std::sinh(alpha);
  constexpr double negligible = 60;  // N_n - 1 decreases as exp(-k alpha)
  double sum = 0;
  for (int n = 1; (2 * n + 1) * alpha < negligible; ++n) {
    const double k = 2 * n + 1, half = std::sinh(k * alpha / 2);
    const double N = (2 * std::sinh(k * alpha) + k * std::sinh(2 * alpha)) /
                     (4 * half * half - k * k * sinh_alpha * sinh_alpha);
    sum += n * (n + 1.0) / ((2 * n - 1.0) * (2 * n + 3.0)) * (N - 1);
  }
  return 4.0 / 3 * sinh_alpha * sum;
}

double rotne_prager_towards_wall(double height) {
  const double near = 1 / height;
  return 1 - (9 * near - 4 * std::pow(near, 3) + std::pow(near, 5)) / 8;
}

WallMapTable::WallMapTable()
    : table_({axis_of_gaps()}, [](const std::array<double, 1>& log_gap) {
        const double height = 1 + std::exp(log_gap[0]);
        return std::array{-0.5 * std::log(drag_towards_wall(height) * rotne_prager_towards_wall(height))};
      }) {}

double WallMapTable::log_map(double height) const {
  return height - 1 > largest_gap ? 0 : table_.at({std::log(height - 1)})[0];
}

}  // namespace beadswim
