#pragma once

#include "beadswim/io/fields_json.hpp"
#include "beadswim/scene/layout.hpp"

// Parts of layouts whose JSON has another form than their fields. The JSON must have been validated against
// its schema.

namespace beadswim {

/// Convert units: "lattice", or an object with length, time and mass, each { "name", "si_factor" }. A layout
/// may contain only the name of a known unit.
void to_json(Json& json, const Units& units);
void from_json(const Json& json, Units& units);

/// Convert the drive of a bond: its harmonics have the name of the quantity as their key.
void to_json(Json& json, const BondDrive& drive);
void from_json(const Json& json, BondDrive& drive);

/// Converts a swimmer type, or a ThreeBeadSwimmer, its shorthand in layouts of version 1. Rest lengths and
/// rest angles that the JSON omits are those of the beads at rest. Numbers of beads, bonds and angles may be
/// wrong; check_layout() reports them.
void from_json(const Json& json, SwimmerType& type);

}  // namespace beadswim
