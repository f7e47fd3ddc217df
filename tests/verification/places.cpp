#include "places.hpp"

#include <cmath>
#include <numbers>
#include <random>

#include "records.hpp"

namespace beadswim::verification {

CubicArray cubic_array(double phi, double cells_per_diameter) {
  const double diameter = std::cbrt(6 * phi / std::numbers::pi);  // over spacing
  const int edge = static_cast<int>(std::lround(cells_per_diameter / diameter));
  return {phi, edge, 0.5 * diameter * edge};
}

Json array_record(const std::string& name, BeadScheme scheme, double relaxation_time, const CubicArray& array,
                  int cells_per_diameter, const std::vector<double>& measured, double reference) {
  const auto [mean, deviation] = mean_and_deviation(measured);
  return {{"case", name},
          {"scheme", to_text(scheme)},
          {"tau", relaxation_time},
          {"phi", array.phi},
          {"cells_per_diameter", cells_per_diameter},
          {"diameter", 2 * array.radius},
          {"edge", array.edge},
          {"places", measured.size()},
          {"measured", mean},
          {"reference", reference},
          {"error", mean / reference - 1},
          {"spread", deviation / reference}};
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
