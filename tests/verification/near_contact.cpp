#include <fmt/core.h>

#include "../collinear/bispherical.hpp"
#include "../mobility/transverse_spheres.hpp"
#include "beadswim/coupling/close_beads.hpp"
#include "cases.hpp"
#include "places.hpp"
#include "records.hpp"
#include "references.hpp"
#include "settling.hpp"
#include "spheres_in_fluid.hpp"

// Measures the resistance of two equal spheres whose gap the lattice does not resolve: the part from the
// lattice, the part that the lubrication correction adds (swimmers/lubrication.hpp), and the exact value.

namespace beadswim::verification {
namespace {

struct Pair {
  double radius = 4;  ///< [cell]
  double gap = 1;     ///< distance of the surfaces [cell]
};

/// Relative motion of two spheres.
struct Mode {
  const char* name;
  bool turn;  ///< equal rotation, surfaces slide; false: approach
};
constexpr Mode approach{"approach", false}, slide{"slide", true};

/// Returns the unit of resistance: 6 pi eta R for approaching spheres, 8 pi eta R^3 for rotating spheres.
double unit(const Pair& pair, const Mode& mode, double eta) {
  return mode.turn ? 8 * pi * eta * std::pow(pair.radius, 3) : 6 * pi * eta * pair.radius;
}

double reference(const Pair& pair, const Mode& mode) {
  return mode.turn ? sliding_torque(pair.gap / pair.radius) : approaching_spheres(2 + pair.gap / pair.radius);
}

/// Returns the lattice part of the resistance, divided by its unit: the force between spheres that approach
/// with the velocities U and -U, or the torque on spheres that rotate with the angular velocity w.
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

/// Returns the part of the resistance that the lubrication correction adds, divided by its unit.
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

std::string error_without_correction(const Json& record) {
  return percent(record["on_lattice"].get<double>() / record["reference"].get<double>() - 1);
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

Law near_contact_law() {
  Law law{
      .title = "Near contact",
      .claim =
          "Resistance of two close spheres with the [correction](method/near-contact.md): approach "
          "(force/6πηRU), slide (torque/8πηR³Ω); 8 cells per diameter unless stated",
      .reference = "Brenner (1961); Lamb's solution about both spheres (`tests/mobility/two_spheres.py`)",
      .test = "gap 0.1 cells, 6 cells per diameter",
  };
  const auto add_row = [&](const Mode& mode, int cells, double gap, Print print) {
    const std::string label = print == error_without_correction ? ", not corrected" : "";
    const std::string resolution = cells == 8 ? "" : fmt::format(", {} cells per diameter", cells);
    law.rows.push_back(
        {fmt::format("{}, gap {:g} cells{}{}", mode.name, gap, label, resolution),
         {{"mode", mode.name}, {"cells_per_diameter", cells}, {"gap_cells", gap}, {"tau", 1.5}},
         print});
  };
  add_row(approach, 8, 0.1, error_without_correction);
  for (const double gap : {0.02, 0.1, 0.5, 1.0, 2.0}) add_row(approach, 8, gap, error_and_spread);
  for (const int cells : {4, 12}) add_row(approach, cells, 0.5, error_and_spread);
  for (const double gap : {0.1, 0.5}) add_row(slide, 8, gap, error_and_spread);
  return law;
}

}  // namespace beadswim::verification
