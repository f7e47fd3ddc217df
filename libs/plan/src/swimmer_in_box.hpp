#pragma once

#include "beadswim/core/vec3.hpp"
#include "beadswim/theory/question.hpp"

namespace beadswim {

/// From the far side of bead 1 to that of bead 3, at rest [length].
inline double length_of(const CollinearSwimmer& swimmer) {
  return swimmer.radius[0] + swimmer.arm[0] + swimmer.arm[1] + swimmer.radius[2];
}

/// In the middle of a periodic box of which the first edge is along the swimmer.
inline BoxPlace in_the_middle(const Vec3& lengths) {
  return {.box = {.lengths = lengths, .boundary = {}},
          .middle_bead = {lengths[0] / 2, lengths[1] / 2, lengths[2] / 2}};
}

}  // namespace beadswim
