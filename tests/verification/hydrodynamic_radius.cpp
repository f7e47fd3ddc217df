#include <fmt/format.h>

#include "array_drag.hpp"
#include "cases.hpp"
#include "places.hpp"
#include "records.hpp"
#include "references.hpp"

// The radius that a sphere on the lattice seems to have, by the drag of an array that it makes up.

namespace beadswim::verification {
namespace {

constexpr double pi = std::numbers::pi;

/// R_h of spheres with R_h K(phi_h) = apparent, phi_h = 4/3 pi (R_h/edge)^3; by bisection near R.
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

std::string report_hydrodynamic_radius(const std::vector<Json>& records) {
  const std::vector<std::string> schemes = schemes_in(records);
  std::string text =
      "## Hydrodynamic radius\n\n"
      "The radius that spheres of a cubic array, spacing four radii, have by their drag, less the radius "
      "that "
      "they were given, in cells: mean over random places within a cell (16; 12 from 4 cells a radius, 8 "
      "from 7, "
      "4 from 10) ± standard deviation over them. `--radius-correction on` gives beads the radius for which "
      "this "
      "mean comes out as the layout's.\n\n" +
      table_head("cells a radius", schemes);
  for (const double radius : values_of<double>(records, "radius")) {
    text += fmt::format("| {:g} |", radius);
    for (const std::string& scheme : schemes) {
      const std::vector<Json> found = where(records, {{"scheme", scheme}, {"radius", radius}});
      text += found.empty() ? " |"
                            : fmt::format(" {:+.4f} ± {:.4f} |", found[0]["excess"].get<double>(),
                                          found[0]["spread"].get<double>() * radius);
    }
    text += "\n";
  }
  return text;
}

}  // namespace beadswim::verification
