#pragma once

#include "beadswim/io/fields_json.hpp"
#include "beadswim/scene/names.hpp"

namespace beadswim {

// Enumerations are their names. Readers take JSON that a schema has let through.

void to_json(Json& json, Boundary boundary);
void from_json(const Json& json, Boundary& boundary);
void to_json(Json& json, DrivingFrame frame);
void from_json(const Json& json, DrivingFrame& frame);

}  // namespace beadswim
