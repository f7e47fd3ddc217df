#pragma once

#include <array>

#include "beadswim/swimmers/swimmer_type.hpp"
#include "beadswim/core/vec3.hpp"

namespace beadswim {

/// Returns the centres of beads 1, 2, 3 at rest. middle: centre of bead 2; axis: unit vector from bead 1 to
/// bead 3.
inline std::array<Vec3, 3> rest_positions(const SwimmerType& type, const Vec3& middle, const Vec3& axis) {
  return {middle - type.springs[0].rest_length * axis, middle, middle + type.springs[1].rest_length * axis};
}

}  // namespace beadswim
