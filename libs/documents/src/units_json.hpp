#pragma once

#include "beadswim/io/fields_json.hpp"
#include "beadswim/scene/layout.hpp"

namespace beadswim {

/// Converts units to JSON: "lattice", or an object with length, time and mass, each { "name", "si_factor" }.
void to_json(Json& json, const Units& units);

/// Converts JSON, which a schema must have validated, to units.
void from_json(const Json& json, Units& units);

}  // namespace beadswim
