#include "stand_in.hpp"

#include <algorithm>
#include <numbers>

#include "beadswim/mobility/rotne_prager.hpp"
#include "beadswim/core/reason_against.hpp"
#include "beadswim/scene/presets.hpp"
#include "beadswim/theory/linear_response.hpp"
#include "beadswim/theory/shaped_swimmer.hpp"

namespace beadswim {
namespace {

constexpr double arms_without_bonds = 10, shortest_arm = 2.5;  // divided by the radius
constexpr double least_swing = 0.05;                           // relative amplitude of the arms

/// Returns the largest amplitude of a bond, divided by its length; 0 if theory does not know it.
double largest_swing(const SwimmerType& type, double viscosity) {
  double largest = 0;
  reason_against([&] {
    const ShapedSwimmer swimmer{type, Eigen::Matrix3d::Identity(), viscosity};
    const ShapeMotion motion = second_order_motion(swimmer, rotne_prager_tensor);
    for (std::size_t k = 0; k < type.bonds.size(); ++k)
      largest = std::max(largest, motion.stroke.amplitude[k] / type.bonds[k].rest_length);
  });
  return largest;
}

}  // namespace

ThreeBeadSwimmer stand_in(const SwimmerType& type, const Fluid& fluid) {
  const double viscosity = fluid.dynamic_viscosity();
  const double radius = std::ranges::max(type.beads, {}, &Bead::radius).radius;
  double arm = type.bonds.empty() ? arms_without_bonds * radius : 0;
  for (const Bond& bond : type.bonds) arm += bond.rest_length / static_cast<double>(type.bonds.size());
  arm = std::max(arm, shortest_arm * radius);
  const double omega = 2 * std::numbers::pi / type.driving.period;
  const Bead bead{.radius = radius, .density = type.beads[0].density};
  const Spring spring{.stiffness = 6 * std::numbers::pi * viscosity * radius * omega, .rest_length = arm};
  ThreeBeadSwimmer swimmer{.beads = {bead, bead, bead},
                           .springs = {spring, spring},
                           .driving = {.amplitude = {1, 1},
                                       .phase = std::numbers::pi / 2,
                                       .period = type.driving.period,
                                       .frame = DrivingFrame::body}};
  swimmer.angular_stiffness = straightening_stiffness(swimmer);
  const CollinearSwimmer line = collinear_swimmer(swimmer, Vec3::UnitX(), viscosity);
  const double by_unit_forces = std::ranges::max(first_order_stroke(line, rotne_prager).amplitude);
  const double swing =
      std::min(std::max(largest_swing(type, viscosity), least_swing) * arm, arm / 2 - radius);
  for (double& amplitude : swimmer.driving.amplitude) amplitude = std::max(swing, 0.0) / by_unit_forces;
  return swimmer;
}

}  // namespace beadswim
