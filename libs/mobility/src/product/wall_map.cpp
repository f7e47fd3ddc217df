#include "beadswim/mobility/wall_map.hpp"

#include <cmath>

namespace beadswim {

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

double log_wall_map(double height, double mobility) {
  constexpr double max_height = 64;
  return height > max_height ? 0 : -0.5 * std::log(drag_towards_wall(height) * mobility);
}

}  // namespace beadswim
