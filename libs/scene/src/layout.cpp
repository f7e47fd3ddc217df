#include "beadswim/scene/layout.hpp"

#include "beadswim/swimmers/rest_positions.hpp"

#include <algorithm>
#include <limits>

namespace beadswim {

SwimmerType Layout::resolved_type(const Swimmer& swimmer) const {
  SwimmerType type = types.at(swimmer.type);
  if (swimmer.driving) type.driving = *swimmer.driving;
  return type;
}

double smallest_radius(const Layout& layout) {
  double smallest = std::numeric_limits<double>::infinity();
  for (const Swimmer& swimmer : layout.swimmers) {
    for (const Bead& bead : layout.types.at(swimmer.type).beads) smallest = std::min(smallest, bead.radius);
  }
  return smallest;
}

std::array<Vec3, 3> rest_positions(const Swimmer& swimmer, const SwimmerType& type) {
  return rest_positions(type, swimmer.position, swimmer.axis);
}

}  // namespace beadswim
