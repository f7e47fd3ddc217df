#pragma once

#include "beadswim/io/fields_json.hpp"
#include "beadswim/scene/layout.hpp"

namespace beadswim {

/// "lattice", or an object of length, time and mass, each { "name", "si_factor" }.
void to_json(Json& json, const Units& units);

/// The inverse, of JSON that a schema has let through.
void from_json(const Json& json, Units& units);

}  // namespace beadswim
