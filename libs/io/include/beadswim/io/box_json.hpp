#pragma once

#include "beadswim/core/box.hpp"
#include "beadswim/io/json.hpp"

// Conversion between JSON and boxes. An axis with walls that move has the boundary
// {"no-slip": {"lower_velocity": [..], "upper_velocity": [..]}}, every other axis a name. The JSON must have
// been validated against its schema before it is read.

namespace beadswim {

void to_json(Json& json, const Box& box);
void from_json(const Json& json, Box& box);

}  // namespace beadswim
