#include "beadswim/scene/presets.hpp"

#include <numbers>

namespace beadswim {

namespace {

/// Returns a layout with the parameters that all scenes of the paper share, in lattice units: equal beads and
/// arms, driving amplitudes A = B, driving phase alpha = pi/2, density 1 of beads and fluid, kinematic
/// viscosity nu = 1/3. `arm` is the rest length.
Layout paper_scene(double radius, double arm, double stiffness, double amplitude, double period) {
  const Bead bead{.radius = radius, .density = 1};
  const Spring spring{.stiffness = stiffness, .rest_length = arm, .damping = 0};
  ThreeBeadSwimmer swimmer{
      .beads = {bead, bead, bead},
      .springs = {spring, spring},
      .driving = {.amplitude = {amplitude, amplitude}, .phase = std::numbers::pi / 2, .period = period}};
  swimmer.angular_stiffness = straightening_stiffness(swimmer);
  const SwimmerType type = swimmer_type(swimmer);

  Layout layout;
  layout.fluid = {.density = 1, .kinematic_viscosity = 1.0 / 3};
  layout.types["a"] = type;
  layout.resolution = unit_resolution(type, layout.fluid);
  return layout;
}

}  // namespace

Layout paper_single() {
  Layout layout = paper_scene(4, 20, 0.0347, 0.2, 4800);
  layout.domain.box = Box{.lengths = Vec3(1200, 800, 800),
                          .boundary = {Boundary::free_slip, Boundary::free_slip, Boundary::free_slip}};
  layout.swimmers = {
      {.type = "a",
       .position = centred_position(layout.types.at("a"), Eigen::Matrix3d::Identity(), layout.domain.box)}};
  return layout;
}

Layout paper_swarm() {
  return paper_scene(6, 32, 0.2, 2, 2000);
}

SwarmPlan paper_uniform_plan() {
  return {.core_gap = Vec3::Constant(32), .block_gap = Vec3::Constant(32)};
}

SwarmPlan paper_defect_plan() {
  return {.core_gap = Vec3::Constant(37), .block_gap = Vec3(56, 46, 46)};
}

double straightening_stiffness(const ThreeBeadSwimmer& swimmer) {
  const double stiffness = (swimmer.springs[0].stiffness + swimmer.springs[1].stiffness) / 2;
  const double length = (swimmer.springs[0].rest_length + swimmer.springs[1].rest_length) / 2;
  return straightening_stiffness(stiffness, length);
}

double straightening_stiffness(double stiffness, double arm) {
  constexpr double sideways_over_along = 10;
  return sideways_over_along * stiffness * arm * arm;
}

Resolution unit_resolution(const SwimmerType& type, const Fluid& fluid) {
  return {.cells_per_radius = smallest_radius(type), .relaxation_time = 3 * fluid.kinematic_viscosity + 0.5};
}

Vec3 shift_off_lattice_planes(const SwimmerType& type, const Vec3& axis, const Box& box) {
  int along = 0;
  axis.cwiseAbs().maxCoeff(&along);
  Vec3 shift = Vec3::Zero();
  shift[(along + 1) % 3] = 0.15;
  shift[(along + 2) % 3] = 0.05;
  for (int a = 0; a < 3; ++a) {
    if (box.boundary[a] != Boundary::periodic) shift[a] = 0;
  }
  return smallest_radius(type) * shift;
}

Vec3 centred_position(const SwimmerType& type, const Eigen::Matrix3d& orientation,
                      const std::optional<Box>& domain) {
  if (!domain) return Vec3::Zero();
  Vec3 position = domain->lengths / 2;
  for (int a = 0; a < 3; ++a) {
    const auto [ahead, behind] = reach_of_surfaces(type, a);
    if (ahead != behind) position -= (ahead - behind) / 2 * orientation.col(a);
  }
  return position + shift_off_lattice_planes(type, orientation.col(0), *domain);
}

}  // namespace beadswim
