#include "scene_facts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

namespace beadswim {

double base_period(const Layout& layout) {
  const auto own = [&](const Swimmer& swimmer) { return layout.resolved_type(swimmer).driving.period; };
  const double first = own(layout.swimmers.front());
  if (std::ranges::all_of(layout.swimmers, [&](const Swimmer& s) { return own(s) == first; })) return first;
  return layout.types.at(layout.swimmers.front().type).driving.period;
}

double shortest_period(const Layout& layout) {
  double shortest = std::numeric_limits<double>::infinity();
  for (const Swimmer& swimmer : layout.swimmers)
    shortest = std::min(shortest, layout.resolved_type(swimmer).driving.period);
  return shortest;
}

TypedSwimmers typed_swimmers(const Layout& layout) {
  TypedSwimmers result;
  std::map<std::string, int> shared_types;  // of swimmers that do not override their type's driving
  for (const Swimmer& swimmer : layout.swimmers) {
    int type = static_cast<int>(result.types.size());
    if (!swimmer.driving) type = shared_types.try_emplace(swimmer.type, type).first->second;
    if (type == std::ssize(result.types)) result.types.push_back(layout.resolved_type(swimmer));
    result.members.push_back({&swimmer, type});
  }
  std::ranges::sort(result.members, {}, [](const auto& member) { return member.swimmer->id; });
  return result;
}

double largest_radius(std::span<const SwimmerType> types) {
  double largest = 0;
  for (const SwimmerType& type : types)
    for (const Bead& bead : type.beads) largest = std::max(largest, bead.radius);
  return largest;
}

DimensionlessNumbers dimensionless_numbers(std::span<const SwimmerType> types, double speed,
                                           double kinematic_viscosity, double period) {
  double smallest = largest_radius(types);
  for (const SwimmerType& type : types)
    for (const Bead& bead : type.beads) smallest = std::min(smallest, bead.radius);
  const double omega = 2 * std::numbers::pi / period;
  return {.reynolds_bead = speed * 2 * largest_radius(types) / kinematic_viscosity,
          .penetration_depth_over_radius = std::sqrt(2 * kinematic_viscosity / omega) / smallest,
          .mach = std::nullopt};
}

}  // namespace beadswim
