#pragma once

#include <string>
#include <vector>

#include "beadswim/scene/layout.hpp"

namespace beadswim {

enum class Quantity { length, time, mass };

/// Names that need no definition, with their size in SI: m ... nm, s ... ns, kg ... fg.
const std::vector<Units::Unit>& known_units(Quantity quantity);

/// The known unit of that name, or nullptr.
const Units::Unit* find_known_unit(Quantity quantity, const std::string& name);

/// Whether numbers in the one mean the same in the other.
bool same_units(const Units& a, const Units& b);

/// As figures call them: "um", "s" and "um/s"; "lattice units" in lattice units.
std::string length_unit(const Units& units);
std::string time_unit(const Units& units);
std::string velocity_unit(const Units& units);

/// "um, s, pg"; "lattice units" in lattice units.
std::string unit_names(const Units& units);

}  // namespace beadswim
