#pragma once

#include "beadswim/io/json.hpp"
#include "beadswim/scene/layout.hpp"

namespace beadswim {

/// "lattice", or an object of length, time and mass, each { "name", "si_factor" }.
Json units_to_json(const Units& units);

/// The inverse, of JSON that a schema has let through.
Units units_from_json(const Json& json);

}  // namespace beadswim
