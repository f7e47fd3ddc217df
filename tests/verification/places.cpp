#include "places.hpp"

#include <cmath>
#include <numbers>
#include <random>

namespace beadswim::verification {

CubicArray cubic_array(double phi, double cells_per_diameter) {
  const double diameter = std::cbrt(6 * phi / std::numbers::pi);  // over spacing
  const int edge = static_cast<int>(std::lround(cells_per_diameter / diameter));
  return {phi, edge, 0.5 * diameter * edge};
}

std::vector<Vec3> random_places(int count) {
  constexpr unsigned seed = 1982;
  std::mt19937_64 bits(seed);
  const auto uniform = [&] { return std::ldexp(static_cast<double>(bits() >> 11), -53); };
  std::vector<Vec3> places;
  for (int n = 0; n < count; ++n) {
    const double x = uniform(), y = uniform(), z = uniform();
    places.push_back({x, y, z});
  }
  return places;
}

}  // namespace beadswim::verification
