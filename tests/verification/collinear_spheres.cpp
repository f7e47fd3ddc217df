#include <fmt/core.h>

#include <Eigen/Dense>

#include "beadswim/collinear/line_flow.hpp"
#include "beadswim/collinear/multipole_mobility.hpp"
#include "cases.hpp"
#include "places.hpp"
#include "records.hpp"
#include "references.hpp"
#include "settling.hpp"
#include "spheres_in_fluid.hpp"

// Measures the mobilities M of two and three equal spheres on a line along x in a periodic box: v = M F.

namespace beadswim::verification {
namespace {

struct Line {
  int spheres = 2;
  double radius = 4;    ///< [cell]
  double distance = 3;  ///< distance of neighbouring centres [radius]
  double margin = 5;    ///< distance of outer centres from the box boundary [radius]
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

/// Returns Rotne and Prager's pair mobility of two spheres, from the flow of one sphere at the position of
/// the other.
double rotne_prager(const Line& line, const SteadyFlow& flow) {
  return flow.oseen.value + 2 * line.radius * line.radius * flow.laplacian.value;
}

/// Returns the exact value of F.M F in unbounded fluid.
double open_mobility(const Line& line, const Eigen::VectorXd& forces, double eta) {
  const std::vector<double> radii(line.spheres, line.radius);
  return forces.dot(multipole_mobility(radii, places_on(line), eta).value * forces);
}

/// Returns the part of F.M F that the periodic box adds by Rotne and Prager's law: images of the forces, and
/// the uniform body force that balances all forces. The mean flow of fluid and spheres is zero.
double image_mobility(const Line& line, const Eigen::VectorXd& forces, double eta) {
  const Index3 cells = box_of(line);
  const std::vector<double> x = places_on(line);
  const LineFlow open(eta),
      box(eta, {.lengths = {double(cells[0]), double(cells[1]), double(cells[2])}}, 0, 0);
  double sum = 0;
  for (int i = 0; i < line.spheres; ++i) {
    for (int j = 0; j < line.spheres; ++j) {
      const double images =
          i == j ? rotne_prager(line, box.steady_images(x[i]))
                 : rotne_prager(line, box.steady(x[i], x[j])) - rotne_prager(line, open.steady(x[i], x[j]));
      sum += forces[i] * images * forces[j];
    }
  }
  return sum;
}

/// Returns the velocity of a far sphere divided by its velocity by Rotne and Prager's law. The ratio differs
/// from 1, because the flow of each sphere strains the others, which increases the far flow. By the
/// reciprocal theorem, the response of the spheres to the far flow of images is larger by the same ratio.
double far_flow_ratio(const Line& line, const Eigen::VectorXd& forces, double eta) {
  constexpr double far = 200;  // [radius]
  std::vector<double> x = places_on(line);
  x.push_back(x.back() + far * line.radius);
  const std::vector<double> radii(x.size(), line.radius);
  const LineFlow open(eta);
  const Eigen::MatrixXd exact = multipole_mobility(radii, x, eta).value;
  double velocity = 0, by_law = 0;
  for (int i = 0; i < line.spheres; ++i) {
    velocity += exact(line.spheres, i) * forces[i];
    by_law += rotne_prager(line, open.steady(x.back(), x[i])) * forces[i];
  }
  return velocity / by_law;
}

double mobility_in_box(const Line& line, const Eigen::VectorXd& forces, double eta) {
  const double ratio = far_flow_ratio(line, forces, eta);
  return open_mobility(line, forces, eta) + ratio * ratio * image_mobility(line, forces, eta);
}

/// Returns the forces along x that move one sphere and keep the others at rest, divided by the speed: one
/// column of M^{-1}.
Eigen::VectorXd resistance_column(const Line& line, int moving, const Vec3& offset, double tau,
                                  BeadScheme scheme) {
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
      fluid.hold_fluid_momentum(with_sphere_at_rest + fluid.fluid_momentum() - fluid.mid_step_momentum());
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

/// Pattern of forces, with its name in the page.
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

void measure(const Line& line, int places, double tau, BeadScheme scheme, const Emit& emit) {
  const double eta = lattice_viscosity(tau);
  std::vector<Eigen::MatrixXd> measured;
  for (const Vec3& place : random_places(places)) {
    Eigen::MatrixXd resistance(line.spheres, line.spheres);
    for (int n = 0; n < line.spheres; ++n) resistance.col(n) = resistance_column(line, n, place, tau, scheme);
    measured.push_back(resistance.inverse());
  }
  for (const Pattern& pattern : patterns_of(line.spheres)) {
    const double reference = mobility_in_box(line, pattern.forces, eta);
    std::vector<double> ratios;
    for (const Eigen::MatrixXd& m : measured)
      ratios.push_back(pattern.forces.dot(m * pattern.forces) / reference);
    const auto [mean, deviation] = mean_and_deviation(ratios);
    emit({{"case", "collinear-spheres"},
          {"scheme", to_text(scheme)},
          {"tau", tau},
          {"spheres", line.spheres},
          {"pattern", pattern.name},
          {"distance", line.distance},
          {"gap_cells", (line.distance - 2) * line.radius},
          {"cells_per_diameter", 2 * line.radius},
          {"diameter", 2 * line.radius},
          {"margin", line.margin},
          {"places", places},
          {"measured", mean * reference},
          {"reference", reference},
          {"box_effect", reference / open_mobility(line, pattern.forces, eta) - 1},
          {"error", mean - 1},
          {"spread", deviation}});
  }
}

constexpr double usual_margin = 5, wide_margin = 7.5;  // [radius]
constexpr double checked_radius = 3;                   // in the wide box [cell]

}  // namespace

void measure_collinear_spheres(BeadScheme scheme, Extent extent, const Emit& emit) {
  if (extent == Extent::brief) return measure({.radius = 3}, 1, 1.5, scheme, emit);
  for (const double distance : {2.25, 2.5, 3.0, 4.0, 6.0})
    measure({.distance = distance}, 2, 1.5, scheme, emit);
  for (const double radius : {2.0, 3.0, 6.0})
    measure({.radius = radius}, radius < 4 ? 4 : 1, 1.5, scheme, emit);
  measure({.radius = checked_radius, .margin = wide_margin}, 4, 1.5, scheme, emit);
  for (const double distance : {2.5, 5.0})
    measure({.spheres = 3, .distance = distance}, 2, 1.5, scheme, emit);
}

Law collinear_spheres_law() {
  Law law{
      .title = "Two and three spheres on a line",
      .claim =
          "F·MF; M: mobility matrix along the line; F: forces on the spheres, whose sum is zero for a "
          "swimmer (apart, against)",
      .reference = "multipole mobility and Ewald sums of the images; uncertain by about 1 %",
      .test = "two spheres, distance 3 R, 6 cells per diameter",
  };
  const auto add_rows = [&](int spheres, double distance, int cells) {
    for (const Pattern& pattern : patterns_of(spheres)) {
      law.rows.push_back(
          {fmt::format("{} spheres at {:g} R, {} cells: {}", spheres, distance, cells, pattern.name),
           {{"spheres", spheres},
            {"distance", distance},
            {"cells_per_diameter", cells},
            {"pattern", pattern.name},
            {"margin", usual_margin}}});
    }
  };
  for (const int cells : {4, 8}) add_rows(2, 3, cells);
  add_rows(2, 2.25, 8);
  add_rows(3, 2.5, 8);
  return law;
}

}  // namespace beadswim::verification
