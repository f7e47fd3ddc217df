#include "beadswim/scene/layout.hpp"

#include <algorithm>
#include <limits>

namespace beadswim {

Eigen::Matrix3d Swimmer::orientation() const {
  Eigen::Matrix3d orientation = turn ? turn->toRotationMatrix() : shortest_turn(axis);
  orientation.col(0) = axis;
  return orientation;
}

SwimmerType Layout::resolved_type(const Swimmer& swimmer) const {
  SwimmerType type = types.at(swimmer.type);
  if (swimmer.driving) type.driving = *swimmer.driving;
  return type;
}

double smallest_radius(const SwimmerType& type) {
  return std::ranges::min_element(type.beads, {}, &Bead::radius)->radius;
}

bool has_background_flow(const Layout& layout) {
  const auto moves = [](const WallVelocities& walls) { return walls.are_moving(); };
  return !layout.body_force.isZero(0) || (layout.domain && std::ranges::any_of(layout.domain->walls, moves));
}

double smallest_radius(const Layout& layout) {
  double smallest = std::numeric_limits<double>::infinity();
  for (const Swimmer& swimmer : layout.swimmers)
    smallest = std::min(smallest, smallest_radius(layout.types.at(swimmer.type)));
  return smallest;
}

namespace {

int largest_multiple(const Driving& driving) {
  int largest = 1;
  for_each_harmonic(driving,
                    [&](const Harmonic& harmonic) { largest = std::max(largest, harmonic.multiple); });
  return largest;
}

}  // namespace

double base_period(const Layout& layout) {
  const auto own = [&](const Swimmer& swimmer) { return layout.resolved_type(swimmer).driving.period; };
  const double first = own(layout.swimmers.front());
  if (std::ranges::all_of(layout.swimmers, [&](const Swimmer& s) { return own(s) == first; })) return first;
  return layout.types.at(layout.swimmers.front().type).driving.period;
}

double shortest_period(const Layout& layout) {
  double shortest = std::numeric_limits<double>::infinity();
  for (const Swimmer& swimmer : layout.swimmers) {
    const Driving driving = layout.resolved_type(swimmer).driving;
    shortest = std::min(shortest, driving.period / largest_multiple(driving));
  }
  return shortest;
}

}  // namespace beadswim
