#include <fmt/format.h>

#include <Eigen/Dense>

#include "beadswim/mobility/line_flow.hpp"
#include "beadswim/mobility/multipole_mobility.hpp"
#include "cases.hpp"
#include "places.hpp"
#include "records.hpp"
#include "settling.hpp"
#include "spheres_in_fluid.hpp"

// Mobilities of two and three equal spheres on a line along x, v = M F, in a periodic box.

namespace beadswim::verification {
namespace {

constexpr double pi = std::numbers::pi;

struct Line {
  int spheres = 2;
  double radius = 4;    ///< [cell]
  double distance = 3;  ///< of neighbours' centres [radius]
  double margin = 5;    ///< of the box around the spheres' centres, on each side [radius]
};

Index3 box_of(const Line& line) {
  const double across = 2 * line.margin, along = across + (line.spheres - 1) * line.distance;
  const int x = static_cast<int>(std::ceil(along * line.radius));
  const int y = static_cast<int>(std::ceil(across * line.radius));
  return {x, y, y};
}

std::vector<double> places_on(const Line& line) {
  std::vector<double> x;
  for (int n = 0; n < line.spheres; ++n) x.push_back((line.margin + n * line.distance) * line.radius);
  return x;
}

/// M of unbounded fluid, exact, and what the box adds to it by Rotne and Prager's law: images of the forces,
/// and the uniform body force that balances them; no mean flow of fluid and spheres together.
Eigen::MatrixXd mobility_in_box(const Line& line, double eta) {
  const Index3 cells = box_of(line);
  const std::vector<double> x = places_on(line), radii(line.spheres, line.radius);
  const LineFlow open(eta),
      box(eta, {.lengths = {double(cells[0]), double(cells[1]), double(cells[2])}}, 0, 0);
  const double size = 2 * line.radius * line.radius;
  const auto value = [&](const SteadyFlow& flow) { return flow.oseen.value + size * flow.laplacian.value; };
  Eigen::MatrixXd mobility = multipole_mobility(radii, x, eta).value;
  for (int i = 0; i < line.spheres; ++i) {
    for (int j = 0; j < line.spheres; ++j) {
      mobility(i, j) += i == j ? value(box.steady_images(x[i]))
                               : value(box.steady(x[i], x[j])) - value(open.steady(x[i], x[j]));
    }
  }
  return mobility;
}

/// Forces along x that keep one sphere moving and the others at rest, per speed: one column of M^{-1}.
Eigen::VectorXd resistance_column(const Line& line, int moving, const Vec3& offset, double tau,
                                  LinkScheme scheme) {
  constexpr double speed = 1e-6, settled_to = 1e-5;
  std::vector<Sphere> spheres;
  const Index3 cells = box_of(line);
  for (const double x : places_on(line))
    spheres.push_back({line.radius, Vec3(x, cells[1] / 2.0, cells[2] / 2.0) + offset});
  SpheresInFluid fluid(cells, tau, scheme, spheres);
  fluid.motion(moving).velocity = Vec3(speed, 0, 0);
  const double sphere_volume = 4 * pi / 3 * std::pow(line.radius, 3);
  const Vec3 with_sphere_at_rest(-sphere_volume * speed, 0, 0);
  const int interval = settling_interval(cells, tau);
  Settling settling(settled_to);
  while (!settling.settled()) {
    std::vector<double> forces(line.spheres, 0.0);
    for (int n = 0; n < interval; ++n) {
      fluid.hold_fluid_momentum(with_sphere_at_rest + 0.5 * fluid.fluid_cells() * fluid.body_force);
      const std::vector<Load> loads = fluid.step();
      if (n < interval - 2) continue;
      // The mean pressure gradient, which balances the body force, acts on spheres too.
      for (int i = 0; i < line.spheres; ++i)
        forces[i] -= 0.5 * (loads[i].force[0] + fluid.body_force[0] * sphere_volume);
    }
    settling.add(forces);
  }
  Eigen::VectorXd column(line.spheres);
  for (int i = 0; i < line.spheres; ++i) column[i] = settling.limits()[i] / speed;
  return column;
}

/// A pattern of forces, and what it is called in the page.
struct Pattern {
  std::string name;
  Eigen::VectorXd forces;
};

std::vector<Pattern> patterns_of(int spheres) {
  if (spheres == 2) return {{"apart", Eigen::Vector2d(1, -1)}, {"together", Eigen::Vector2d(1, 1)}};
  return {{"ends apart", Eigen::Vector3d(1, 0, -1)},
          {"ends against middle", Eigen::Vector3d(1, -2, 1)},
          {"together", Eigen::Vector3d(1, 1, 1)}};
}

void measure(const Line& line, int places, double tau, LinkScheme scheme, const Emit& emit) {
  const Eigen::MatrixXd reference = mobility_in_box(line, lattice_viscosity(tau));
  const std::vector<double> x = places_on(line), radii(line.spheres, line.radius);
  const Eigen::MatrixXd open = multipole_mobility(radii, x, lattice_viscosity(tau)).value;
  std::vector<Eigen::MatrixXd> measured;
  for (const Vec3& place : random_places(places)) {
    Eigen::MatrixXd resistance(line.spheres, line.spheres);
    for (int n = 0; n < line.spheres; ++n) resistance.col(n) = resistance_column(line, n, place, tau, scheme);
    measured.push_back(resistance.inverse());
  }
  for (const Pattern& pattern : patterns_of(line.spheres)) {
    const auto dissipation = [&](const Eigen::MatrixXd& m) { return pattern.forces.dot(m * pattern.forces); };
    std::vector<double> ratios;
    for (const Eigen::MatrixXd& m : measured) ratios.push_back(dissipation(m) / dissipation(reference));
    const auto [mean, deviation] = mean_and_deviation(ratios);
    emit({{"case", "collinear-spheres"},
          {"scheme", name_of(scheme)},
          {"tau", tau},
          {"spheres", line.spheres},
          {"pattern", pattern.name},
          {"distance", line.distance},
          {"gap_cells", (line.distance - 2) * line.radius},
          {"cells_per_diameter", 2 * line.radius},
          {"diameter", 2 * line.radius},
          {"margin", line.margin},
          {"places", places},
          {"measured", mean * dissipation(reference)},
          {"reference", dissipation(reference)},
          {"box_effect", dissipation(reference) / dissipation(open) - 1},
          {"error", mean - 1},
          {"spread", deviation}});
  }
}

/// Rows: distances; columns: patterns of each scheme.
std::string distance_table(const std::vector<Json>& records, int spheres) {
  std::vector<std::string> columns;
  for (const std::string& scheme : schemes_in(records)) {
    for (const Pattern& pattern : patterns_of(spheres)) columns.push_back(scheme + ", " + pattern.name);
  }
  std::string text =
      table_head("distance, gap, box's effect (" + patterns_of(spheres)[0].name + " .. together)", columns);
  for (const double distance : values_of<double>(records, "distance")) {
    const auto row = where(records, {{"distance", distance}});
    const auto box = [&](const std::string& pattern) {
      return percent(where(row, {{"pattern", pattern}})[0]["box_effect"]);
    };
    text += fmt::format("| {:g} R, {:g} cells, {} .. {} |", distance, row[0]["gap_cells"].get<double>(),
                        box(patterns_of(spheres)[0].name), box("together"));
    for (const std::string& scheme : schemes_in(records)) {
      for (const Pattern& pattern : patterns_of(spheres)) {
        const auto found = where(row, {{"scheme", scheme}, {"pattern", pattern.name}});
        text += found.empty() ? " |" : " " + error_and_spread(found[0]) + " |";
      }
    }
    text += "\n";
  }
  return text;
}

std::string resolution_tables(const std::vector<Json>& records) {
  std::string text;
  for (const Pattern& pattern : patterns_of(2)) {
    text += fmt::format("\nForces {}:\n\n", pattern.name) +
            resolution_table(where(records, {{"pattern", pattern.name}}));
  }
  return text;
}

constexpr double usual_margin = 5, wide_margin = 7.5;  // [radius]

std::string box_check(const std::vector<Json>& records) {
  const auto errors = [&](double margin) {
    return where(records, {{"spheres", 2}, {"distance", 3}, {"cells_per_diameter", 8}, {"margin", margin}});
  };
  std::string text;
  for (const Json& wide : errors(wide_margin)) {
    const auto usual =
        where(errors(usual_margin), {{"scheme", wide["scheme"]}, {"pattern", wide["pattern"]}});
    if (usual.empty()) continue;
    text +=
        fmt::format("| {}, {} | {} | {} |\n", wide["scheme"].get<std::string>(),
                    wide["pattern"].get<std::string>(), percent(usual[0]["error"]), percent(wide["error"]));
  }
  return text;
}

}  // namespace

void measure_collinear_spheres(LinkScheme scheme, Extent extent, const Emit& emit) {
  if (extent == Extent::brief) return measure({.radius = 3}, 1, 1.5, scheme, emit);
  for (const double distance : {2.25, 2.5, 3.0, 4.0, 6.0})
    measure({.distance = distance}, 4, 1.5, scheme, emit);
  for (const double radius : {2.0, 3.0, 6.0}) measure({.radius = radius}, 4, 1.5, scheme, emit);
  measure({.margin = wide_margin}, 4, 1.5, scheme, emit);
  for (const double distance : {2.5, 3.0, 5.0}) {
    measure({.spheres = 3, .distance = distance}, 2, 1.5, scheme, emit);
  }
}

std::string report_collinear_spheres(const std::vector<Json>& all) {
  std::string text =
      "## Two and three spheres on a line\n\n"
      "Spheres held on a line along x, each in turn given a velocity; forces on all, quasi-steady, make the "
      "resistance matrix, and its inverse the mobility M. Given is the error of F.M F for patterns F of "
      "forces; "
      "those of zero sum are what a swimmer uses. Mean over random places ± standard deviation, 8 cells a "
      "diameter unless said otherwise, τ = 1.5, the box reaching 5 R beyond the outer spheres' centres.\n\n"
      "Reference: exact mobility in unbounded fluid by multipoles (good to 1e-12), and on top what the "
      "periodic "
      "box adds, by Ewald sums of the Rotne-Prager tensor. The box's effect is printed beside the gap: it "
      "is small where forces have zero sum. Its own error comes from reflections between spheres and images "
      "and is judged by a wider box, below.\n\n";
  const std::vector<Json> records = where(all, {{"margin", usual_margin}});
  const std::vector<Json> of_8 = where(records, {{"cells_per_diameter", 8}});
  text += "Two spheres:\n\n" + distance_table(where(of_8, {{"spheres", 2}}), 2);
  if (!where(of_8, {{"spheres", 3}}).empty())
    text += "\nThree spheres:\n\n" + distance_table(where(of_8, {{"spheres", 3}}), 3);
  text += "\nTwo spheres 3 R apart at several resolutions:\n" +
          resolution_tables(where(records, {{"spheres", 2}, {"distance", 3}}));
  const std::string boxes = box_check(all);
  if (boxes.empty()) return text;
  return text + "\nTwo spheres 3 R apart in the box above and in one that reaches 7.5 R beyond them:\n\n" +
         table_head("scheme, forces", {"5 R", "7.5 R"}) + boxes;
}

}  // namespace beadswim::verification
