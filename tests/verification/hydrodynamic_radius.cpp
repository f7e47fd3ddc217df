#include <fmt/core.h>

#include "array_drag.hpp"
#include "cases.hpp"
#include "places.hpp"
#include "records.hpp"
#include "references.hpp"

// Measures the hydrodynamic radius of a sphere on the lattice: the radius of a sphere that has the measured
// drag in an array.

namespace beadswim::verification {
namespace {

/// Returns the radius R_h with R_h K(phi_h) = apparent, phi_h = 4/3 pi (R_h/edge)^3, by bisection close to R.
/// K: drag coefficient of an array.
double hydrodynamic_radius(double apparent, double radius, int edge) {
  double low = 0.5 * radius, high = 1.5 * radius;
  for (int n = 0; n < 60; ++n) {
    const double middle = 0.5 * (low + high);
    const double phi = 4.0 / 3 * pi * std::pow(middle / edge, 3);
    (middle * cubic_array_drag(phi) < apparent ? low : high) = middle;
  }
  return low;
}

void measure(double radius, int places, BeadScheme scheme, const Emit& emit) {
  constexpr double tau = 1.5;
  const int edge = static_cast<int>(std::lround(4 * radius));
  const CubicArray array{.phi = 4.0 / 3 * pi * std::pow(radius / edge, 3), .edge = edge, .radius = radius};
  std::vector<double> excesses;
  for (const Vec3& place : random_places(places)) {
    const double drag = array_drag(array, place, tau, scheme);
    excesses.push_back(hydrodynamic_radius(radius * drag, radius, edge) - radius);
  }
  const auto [mean, deviation] = mean_and_deviation(excesses);
  emit({{"case", "hydrodynamic-radius"},
        {"scheme", to_text(scheme)},
        {"tau", tau},
        {"radius", radius},
        {"edge", edge},
        {"places", places},
        {"reference", radius},
        {"measured", radius + mean},
        {"error", mean / radius},
        {"excess", mean},
        {"spread", deviation / radius}});
}

std::string excess_in_cells(const Json& record) {
  return fmt::format("{:+.3f} ± {:.3f}", record["excess"].get<double>(),
                     record["spread"].get<double>() * record["radius"].get<double>());
}

}  // namespace

void measure_hydrodynamic_radius(BeadScheme scheme, Extent extent, const Emit& emit) {
  if (extent == Extent::brief) {
    for (const double radius : {2.0, 3.5}) measure(radius, 4, scheme, emit);
    return;
  }
  for (double radius = 1.5; radius < 4; radius += 0.25) measure(radius, 16, scheme, emit);
  for (double radius = 4; radius <= 6; radius += 0.5) measure(radius, 12, scheme, emit);
  for (const double radius : {7.0, 8.0}) measure(radius, 8, scheme, emit);
  for (const double radius : {10.0, 12.0}) measure(radius, 4, scheme, emit);
}

Law hydrodynamic_radius_law() {
  Law law{
      .title = "Hydrodynamic radius",
      .claim =
          "Radius that has the measured drag in an array of spacing 4 R, minus R; "
          "`--radius-correction on` removes its mean",
      .reference = "drag of the array, as above",
      .test = "R = 2, 3.5 cells; error relative to R",
      .quantity = "Excess radius [cell]",
  };
  for (const double radius : {1.5, 2.0, 3.0, 4.0, 6.0, 12.0})
    law.rows.push_back({fmt::format("R = {:g} cells", radius), {{"radius", radius}}, excess_in_cells});
  return law;
}

}  // namespace beadswim::verification
