#include "beadswim/scene/layout.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <limits>

#include "beadswim/core/setting.hpp"

namespace beadswim {

Eigen::Matrix3d Swimmer::orientation() const {
  Eigen::Matrix3d orientation = turn ? turn->toRotationMatrix() : shortest_turn(axis);
  orientation.col(0) = axis;
  return orientation;
}

void Swimmer::move_to(const Vec3& new_position) {
  if (start)
    for (Vec3& bead : start->positions) bead += new_position - position;
  position = new_position;
}

void Swimmer::turn_start(const Eigen::Quaterniond& rotation) {
  if (start)
    for (Vec3& bead : start->positions) bead = position + rotation * (bead - position);
}

const Driving& Layout::driving_of(const Swimmer& swimmer) const {
  return swimmer.driving ? *swimmer.driving : types.at(swimmer.type).driving;
}

SwimmerType Layout::resolved_type(const Swimmer& swimmer) const {
  SwimmerType type = types.at(swimmer.type);
  if (swimmer.driving) type.driving = *swimmer.driving;
  return type;
}

double smallest_radius(const SwimmerType& type) {
  return std::ranges::min_element(type.beads, {}, &Bead::radius)->radius;
}

std::string in_words(const Domain& domain) {
  if (domain.half_space)
    return fmt::format("half-space {} > 0 over a no-slip wall", "xyz"[domain.half_space->axis]);
  if (!domain.box) return "open space";
  const Vec3& box = domain.box->lengths;
  return fmt::format("box {:g} × {:g} × {:g}", box.x(), box.y(), box.z());
}

bool has_background_flow(const Layout& layout) {
  const auto moves = [](const WallVelocities& walls) { return walls.are_moving(); };
  const auto& box = layout.domain.box;
  return !layout.flow.is_zero() || !layout.body_force.isZero(0) ||
         (box && std::ranges::any_of(box->walls, moves));
}

double smallest_radius(const Layout& layout) {
  double smallest = std::numeric_limits<double>::infinity();
  for (const Swimmer& swimmer : layout.swimmers)
    smallest = std::min(smallest, smallest_radius(layout.types.at(swimmer.type)));
  return smallest;
}

double base_period(const Layout& layout) {
  const auto own = [&](const Swimmer& swimmer) { return layout.driving_of(swimmer).period; };
  const double first = own(layout.swimmers.front());
  if (std::ranges::all_of(layout.swimmers, [&](const Swimmer& s) { return own(s) == first; })) return first;
  return layout.types.at(layout.swimmers.front().type).driving.period;
}

double shortest_period(const Layout& layout) {
  double shortest = std::numeric_limits<double>::infinity();
  for (const Swimmer& swimmer : layout.swimmers) {
    const Driving& driving = layout.driving_of(swimmer);
    shortest = std::min(shortest, driving.period);
    for_each_harmonic(driving, [&](const Harmonic& harmonic) {
      shortest = std::min(shortest, driving.period / harmonic.multiple);
    });
  }
  return shortest;
}

std::string models_with_noise(const Layout& layout) {
  double period = std::numeric_limits<double>::infinity();
  for (const Swimmer& swimmer : layout.swimmers) period = std::min(period, layout.driving_of(swimmer).period);
  const double radius = smallest_radius(layout);
  return fmt::format(
      "{} rpy, rpy+near or multipole, which neglect the inertia of the fluid: its momentum spreads around "
      "a bead within {:.2g} periods, which must be little",
      Setting::model, radius * radius / (layout.fluid.kinematic_viscosity * period));
}

}  // namespace beadswim
