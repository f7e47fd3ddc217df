#include <fmt/core.h>

#include <memory>

#include "cases.hpp"
#include "places.hpp"
#include "records.hpp"
#include "references.hpp"
#include "settling.hpp"
#include "spheres_in_fluid.hpp"

// Measures the drag of a cubic array in frames of reference that move along or perpendicularly to the drag.

namespace beadswim::verification {
namespace {

constexpr double phi = 0.027;
constexpr double relative_speed = 1e-3;  ///< velocity of the fluid relative to the sphere along x [cell/step]

/// Results in one frame of reference: the drag coefficient K along x, and the relative flow along z divided
/// by the relative flow along x.
struct Seen {
  double drag, across;
};

/// Sums of the force and of the relative flow over time steps.
struct Sums {
  long steps = 0;
  Vec3 force = Vec3::Zero(), flow = Vec3::Zero();

  void add(SpheresInFluid& fluid) {
    flow += (fluid.mid_step_momentum() - fluid.fluid_cells() * fluid.motion(0).velocity) / fluid.volume();
    force += fluid.body_force * fluid.volume();
    ++steps;
  }
  Seen seen(const CubicArray& array, double tau) const {
    const double friction = 6 * pi * lattice_viscosity(tau) * array.radius;
    return {force[0] / (friction * flow[0]), flow[2] / flow[0]};
  }
};

std::unique_ptr<SpheresInFluid> start(const CubicArray& array, const Vec3& offset, const Vec3& drift,
                                      double tau, BeadScheme scheme) {
  auto fluid = std::make_unique<SpheresInFluid>(
      Index3::Constant(array.edge), tau, scheme,
      std::vector<Sphere>{{array.radius, Vec3::Constant(array.edge / 2.0) + offset}});
  fluid->start_fluid(drift + Vec3(relative_speed, 0, 0));
  fluid->motion(0).velocity = drift;
  const double force =
      6 * pi * lattice_viscosity(tau) * array.radius * cubic_array_drag(array.phi) * relative_speed;
  fluid->body_force = Vec3(force / fluid->volume(), 0, 0);
  return fluid;
}

int steps_to_settle(const CubicArray& array, double tau) {
  const double friction_time = std::pow(array.edge, 3) /
                               (6 * pi * lattice_viscosity(tau) * array.radius * cubic_array_drag(array.phi));
  return static_cast<int>(12 * std::max(friction_time, diffusion_time(Index3::Constant(array.edge), tau)));
}

/// Measures at positions along the path of the moving sphere, but with the sphere at rest.
Seen at_rest(const CubicArray& array, const Vec3& direction, double tau, BeadScheme scheme) {
  constexpr int places = 16;
  Sums sums;
  for (int k = 0; k < places; ++k) {
    const Vec3 offset = (k + 0.5) / places * direction + Vec3(0.05, 0.3, 0.1);
    const auto fluid = start(array, offset, Vec3::Zero(), tau, scheme);
    for (int n = steps_to_settle(array, tau); n > 0; --n) fluid->step();
    for (int n = 0; n < 2; ++n) {
      fluid->step();
      sums.add(*fluid);
    }
  }
  return sums.seen(array, tau);
}

/// Measures with the sphere moving along an axis over whole cells.
Seen moving(const CubicArray& array, const Vec3& drift, double tau, BeadScheme scheme) {
  const auto fluid = start(array, Vec3(0.05, 0.3, 0.1), drift, tau, scheme);
  for (int n = steps_to_settle(array, tau); n > 0; --n) {
    fluid->step();
    fluid->move();
  }
  const int cells = std::max(4, static_cast<int>(2000 * drift.norm()));
  Sums sums;
  for (long n = std::lround(cells / drift.norm()); n > 0; --n) {
    fluid->step();
    sums.add(*fluid);
    fluid->move();
  }
  return sums.seen(array, tau);
}

void measure(const std::vector<std::string>& axes, const std::vector<double>& speeds, int cells_per_diameter,
             double tau, BeadScheme scheme, const Emit& emit) {
  const CubicArray array = cubic_array(phi, cells_per_diameter);
  for (const std::string& along : axes) {
    const Vec3 direction = along == "x" ? Vec3::UnitX() : Vec3::UnitZ();
    const Seen rest = at_rest(array, direction, tau, scheme);
    for (const double speed : speeds) {
      const Seen seen = moving(array, speed * direction, tau, scheme);
      emit({{"case", "galilean-invariance"},
            {"scheme", to_text(scheme)},
            {"tau", tau},
            {"phi", phi},
            {"cells_per_diameter", cells_per_diameter},
            {"along", along},
            {"drift", speed},
            {"measured", seen.drag},
            {"reference", rest.drag},
            {"error", seen.drag / rest.drag - 1},
            {"across", seen.across}});
    }
  }
}

std::string error_only(const Json& record) {
  return percent(record["error"]);
}

}  // namespace

void measure_galilean_invariance(BeadScheme scheme, Extent extent, const Emit& emit) {
  if (extent == Extent::brief) return measure({"x"}, {1e-2}, 6, 1.5, scheme, emit);
  measure({"x", "z"}, {-1e-1, -1e-3, 1e-3, 1e-2, 3e-2, 1e-1}, 8, 1.5, scheme, emit);
  measure({"x", "z"}, {-1e-3, 1e-2, 1e-1}, 8, 0.8, scheme, emit);
}

Law galilean_invariance_law() {
  Law law{
      .title = "Drag in moving frames",
      .claim =
          "A drift u of sphere and fluid does not change the drag; relative velocity 0.001 cells per "
          "step along x",
      .reference = "drag without drift; the lattice's own error is of order 3u²",
      .test = "u = 0.01 along x, 6 cells per diameter",
      .quantity = "Change [%]",
  };
  for (const double drift : {0.01, 0.03, 0.1, -0.1}) {
    law.rows.push_back({fmt::format("u = {:g} cells per step along x", drift),
                        {{"along", "x"}, {"drift", drift}, {"tau", 1.5}},
                        error_only});
  }
  law.rows.push_back({"u = 0.1 along z", {{"along", "z"}, {"drift", 0.1}, {"tau", 1.5}}, error_only});
  return law;
}

}  // namespace beadswim::verification
