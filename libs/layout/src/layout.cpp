#include "beadswim/layout/layout.hpp"

namespace beadswim {

SwimmerType Layout::resolved_type(const Swimmer& swimmer) const {
  SwimmerType type = types.at(swimmer.type);
  if (swimmer.driving) type.driving = *swimmer.driving;
  return type;
}

std::array<Vec3, 3> rest_positions(const Swimmer& swimmer, const SwimmerType& type) {
  return {swimmer.position - type.springs[0].rest_length * swimmer.axis, swimmer.position,
          swimmer.position + type.springs[1].rest_length * swimmer.axis};
}

}  // namespace beadswim
