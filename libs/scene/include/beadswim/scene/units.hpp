#pragma once

#include <string>
#include <vector>

#include "beadswim/scene/layout.hpp"

namespace beadswim {

enum class Quantity { length, time, mass };

/// Returns the units that a layout may use without a definition, with their size in SI: m ... nm, s ... ns,
/// kg ... fg.
const std::vector<Units::Unit>& known_units(Quantity quantity);

/// Returns the known unit with this name, or nullptr.
const Units::Unit* find_known_unit(Quantity quantity, const std::string& name);

/// Exponents of mass, length and time in a unit.
struct UnitExponents {
  int mass = 0, length = 0, time = 0;
  bool is_angle = false;  ///< the unit contains the radian
};

/// Returns a unit for figures: "pg um/s²", "rad", or "lattice units"; empty if there is none.
std::string unit_text(const UnitExponents& unit, const Units& units);

/// Return the names of units for figures: "um" and "um/s", or "lattice units".
std::string length_unit(const Units& units);
std::string velocity_unit(const Units& units);

/// Returns the names of all three units: "um, s, pg", or "lattice units".
std::string unit_names(const Units& units);

}  // namespace beadswim
