#include <fmt/format.h>

#include "../mobility/bispherical.hpp"
#include "../mobility/transverse_spheres.hpp"
#include "beadswim/coupling/close_beads.hpp"
#include "cases.hpp"
#include "places.hpp"
#include "records.hpp"
#include "settling.hpp"
#include "spheres_in_fluid.hpp"

// Two equal spheres closer than cells resolve: what the lattice has of their resistance, what the correction
// adds (swimmers/lubrication.hpp), and what it should be.

namespace beadswim::verification {
namespace {

constexpr double pi = std::numbers::pi;

struct Pair {
  double radius = 4;  ///< [cell]
  double gap = 1;     ///< between surfaces [cell]
};

/// How two spheres move.
struct Mode {
  const char* name;
  bool turn;  ///< both alike, so that their surfaces slide; else they approach each other
};
constexpr Mode approach{"approach", false}, slide{"slide", true};

/// 6 pi eta R U, of one that moves with U, or 8 pi eta R^3 w
double unit(const Pair& pair, const Mode& mode, double eta) {
  return mode.turn ? 8 * pi * eta * std::pow(pair.radius, 3) : 6 * pi * eta * pair.radius;
}

double reference(const Pair& pair, const Mode& mode) {
  return mode.turn ? sliding_torque(pair.gap / pair.radius) : approaching_spheres(2 + pair.gap / pair.radius);
}

/// Force between spheres that approach with U each, torque on spheres that turn with w, over the unit.
double on_lattice(const Pair& pair, const Mode& mode, const Vec3& direction, const Vec3& offset, double tau,
                  BeadScheme scheme) {
  constexpr double margin = 4;  // of the box around the spheres [radius]
  constexpr double rate = 1e-6, settled_to = 1e-4;
  const double distance = 2 * pair.radius + pair.gap;
  const Index3 cells = Index3::Constant(static_cast<int>(std::ceil(distance + 2 * margin * pair.radius)));
  const Vec3 middle = cells.cast<double>().matrix() / 2 + offset, half = 0.5 * distance * direction;
  const double radius = corrected_radius(scheme, pair.radius);
  SpheresInFluid fluid(cells, tau, scheme, {{radius, middle - half}, {radius, middle + half}});
  const Vec3 across = direction.unitOrthogonal();
  for (const int s : {0, 1}) {
    if (mode.turn) fluid.motion(s).angular_velocity = rate * across;
    if (!mode.turn) fluid.motion(s).velocity = (s == 0 ? rate : -rate) * direction;
  }
  const auto resistance = [&] {
    const std::vector<Load> loads = fluid.step();
    return mode.turn ? -0.5 * (loads[0].torque + loads[1].torque).dot(across)
                     : 0.5 * (loads[1].force - loads[0].force).dot(direction);
  };
  const int interval = settling_interval(cells, tau);
  Settling settling(settled_to);
  while (!settling.settled()) {
    for (int n = 0; n < interval - 2; ++n) fluid.step();
    const double before = resistance();
    settling.add({0.5 * (before + resistance())});
  }
  return settling.limits()[0] / (rate * unit(pair, mode, lattice_viscosity(tau)));
}

/// What the correction adds.
double added(const Pair& pair, const Mode& mode, double tau, BeadScheme scheme) {
  const double r = pair.radius, eta = lattice_viscosity(tau);
  const LubricationRange range = lubrication_range(scheme, r);
  if (mode.turn) {
    const Sliding film = sliding(r, r, eta, range, pair.gap);
    return (film.aa + film.ab) / unit(pair, mode, eta);
  }
  return 2 * squeezing(r, r, eta, range, pair.gap).resistance /
         unit(pair, mode, eta);  // they approach with 2 U
}

void measure(const Pair& pair, int places, double tau, BeadScheme scheme, const Emit& emit) {
  const std::vector<Vec3> random = random_places(2 * places);
  for (const Mode& mode : {approach, slide}) {
    std::vector<double> values;
    for (int n = 0; n < places; ++n) {
      const Vec3 direction = (random[places + n] - Vec3::Constant(0.5)).normalized();
      values.push_back(on_lattice(pair, mode, direction, random[n], tau, scheme));
    }
    const auto [mean, deviation] = mean_and_deviation(values);
    const double right = reference(pair, mode), correction = added(pair, mode, tau, scheme);
    emit({{"case", "near-contact"},
          {"scheme", to_text(scheme)},
          {"tau", tau},
          {"mode", mode.name},
          {"cells_per_diameter", 2 * pair.radius},
          {"gap_cells", pair.gap},
          {"places", places},
          {"on_lattice", mean},
          {"added", correction},
          {"measured", mean + correction},
          {"reference", right},
          {"error", (mean + correction) / right - 1},
          {"spread", deviation / right}});
  }
}

/// Rows: gaps; columns: schemes, without and with the correction.
std::string gap_table(const std::vector<Json>& records) {
  const std::vector<std::string> schemes = schemes_in(records);
  std::vector<std::string> columns{"exact"};
  for (const std::string& scheme : schemes) columns.push_back(scheme + ": lattice, corrected");
  std::string text = table_head("gap (cells)", columns);
  for (const double gap : values_of<double>(records, "gap_cells")) {
    const auto row = where(records, {{"gap_cells", gap}});
    text += fmt::format("| {:g} | {:.3f} |", gap, row[0]["reference"].get<double>());
    for (const std::string& scheme : schemes) {
      const auto found = where(row, {{"scheme", scheme}});
      text += found.empty() ? " |"
                            : fmt::format(" {:.3f}, {} |", found[0]["on_lattice"].get<double>(),
                                          error_and_spread(found[0]));
    }
    text += "\n";
  }
  return text;
}

}  // namespace

void measure_near_contact(BeadScheme scheme, Extent extent, const Emit& emit) {
  if (extent == Extent::brief) return measure({.radius = 3, .gap = 0.1}, 2, 1.5, scheme, emit);
  for (const double gap : {0.02, 0.05, 0.1, 0.25, 0.5, 0.75, 1.0, 1.5, 2.0})
    measure({.radius = 4, .gap = gap}, 6, 1.5, scheme, emit);
  for (const double gap : {0.1, 0.5, 1.0}) {
    measure({.radius = 2, .gap = gap}, 6, 1.5, scheme, emit);
    for (const double tau : {0.8, 3.0}) measure({.radius = 4, .gap = gap}, 2, tau, scheme, emit);
    measure({.radius = 6, .gap = gap}, 2, 1.5, scheme, emit);
  }
}

std::string report_near_contact(const std::vector<Json>& records) {
  std::string text =
      "## Near contact\n\n"
      "Two spheres held in place, random places within a cell and random directions of their line, in a "
      "periodic cube that reaches 4 R beyond them. They approach each other, or turn alike so that their "
      "surfaces "
      "slide. Exact: Brenner (1961); Lamb's solution about both spheres (tests/mobility/two_spheres.py). "
      "Below "
      "some gap the lattice's resistance grows no more; "
      "the "
      "cut-offs are where the exact resistance equals what it stays at, and the correction of "
      "[near contact](method/near-contact.md) adds what is missing below. \"Lattice\": mean resistance "
      "without "
      "it; \"corrected\": error of the mean with it ± standard deviation over places. The box is left out of "
      "the reference.\n\n";
  for (const double tau : {1.5, 0.8, 3.0}) {
    for (const double cells : values_of<double>(where(records, {{"tau", tau}}), "cells_per_diameter")) {
      for (const Mode& mode : {approach, slide}) {
        text += fmt::format(
            "{} at {:g} cells a diameter, τ = {:g}:\n\n{}\n",
            mode.turn ? "Sliding, torque over 8πηR³Ω," : "Approach, force over 6πηRU,", cells, tau,
            gap_table(where(records, {{"tau", tau}, {"cells_per_diameter", cells}, {"mode", mode.name}})));
      }
    }
  }
  return text;
}

}  // namespace beadswim::verification
