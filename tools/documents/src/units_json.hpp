#pragma once

#include "beadswim/io/fields_json.hpp"
#include "beadswim/scene/layout.hpp"

namespace beadswim {

/// Writes units as "lattice", or as an object with length, time and mass, each { "name", "si_factor" }.
void to_json(Json& json, const Units& units);

/// Reads units from JSON that a schema has validated.
void from_json(const Json& json, Units& units);

}  // namespace beadswim
