#pragma once

#include "beadswim/core/box.hpp"
#include "beadswim/io/json.hpp"

// Conversion between JSON and domains and boxes, whose JSON has another form than their fields
// (fields_json.hpp includes this header). A domain is null, a box or
// {"half_space": {"axis": "z", "boundary": "no-slip"}}. An axis with walls that move has the boundary
// {"no-slip": {"lower_velocity": [..], "upper_velocity": [..]}}, every other axis a name. The JSON must have
// been validated against its schema before it is read.

namespace beadswim {

void to_json(Json& json, const Box& box);
void from_json(const Json& json, Box& box);
void to_json(Json& json, const Domain& domain);
void from_json(const Json& json, Domain& domain);

}  // namespace beadswim
