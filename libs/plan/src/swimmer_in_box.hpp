#pragma once

#include "beadswim/core/vec3.hpp"
#include "beadswim/theory/question.hpp"

namespace beadswim {

/// Returns the length of the swimmer at rest, including the radii of beads 1 and 3 [length].
inline double swimmer_length(const CollinearSwimmer& swimmer) {
  return swimmer.radius[0] + swimmer.arm[0] + swimmer.arm[1] + swimmer.radius[2];
}

/// Returns a periodic box with bead 2 at its centre. The first edge is parallel to the swimmer.
inline BoxPlace box_place_at_centre(const Vec3& lengths) {
  return {.box = {.lengths = lengths, .boundary = {}},
          .middle_bead = {lengths[0] / 2, lengths[1] / 2, lengths[2] / 2}};
}

}  // namespace beadswim
