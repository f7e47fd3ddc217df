#include "beadswim/layout/presets.hpp"

#include <algorithm>
#include <numbers>

namespace beadswim {

Layout paper_single() {
  const Bead bead{.radius = 4, .density = 1};
  const Spring spring{.stiffness = 0.0347, .rest_length = 20, .damping = 0};
  const Driving driving{.amplitude = {0.2, 0.2}, .phase = std::numbers::pi / 2, .period = 4800};
  SwimmerType type{.beads = {bead, bead, bead}, .springs = {spring, spring}, .driving = driving};
  type.angular_stiffness = straightening_stiffness(type);

  Layout layout;
  layout.fluid = {.density = 1, .kinematic_viscosity = 1.0 / 3};
  layout.domain = Domain{.lengths = Vec3(1200, 800, 800),
                         .boundary = {Boundary::free_slip, Boundary::free_slip, Boundary::free_slip}};
  layout.types["a"] = type;
  layout.swimmers = {{.type = "a", .position = centred_position(type, Vec3::UnitX(), layout.domain)}};
  layout.resolution = unit_resolution(type, layout.fluid);
  return layout;
}

double straightening_stiffness(const SwimmerType& type) {
  constexpr double sideways_over_along = 10;
  const double stiffness = (type.springs[0].stiffness + type.springs[1].stiffness) / 2;
  const double length = (type.springs[0].rest_length + type.springs[1].rest_length) / 2;
  return sideways_over_along * stiffness * length * length;
}

Resolution unit_resolution(const SwimmerType& type, const Fluid& fluid) {
  const auto smaller = [](const Bead& a, const Bead& b) { return a.radius < b.radius; };
  const Bead& smallest = *std::min_element(type.beads.begin(), type.beads.end(), smaller);
  return {.cells_per_radius = smallest.radius, .relaxation_time = 3 * fluid.kinematic_viscosity + 0.5};
}

Vec3 centred_position(const SwimmerType& type, const Vec3& axis, const std::optional<Domain>& domain) {
  if (!domain) return Vec3::Zero();
  const double ahead = type.springs[1].rest_length + type.beads[2].radius;
  const double behind = type.springs[0].rest_length + type.beads[0].radius;
  return domain->lengths / 2 - (ahead - behind) / 2 * axis;
}

}  // namespace beadswim
