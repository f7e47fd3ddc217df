#pragma once

#include "beadswim/study/optimisation.hpp"

namespace beadswim {

/// Parses NAME=FROM:TO, or NAME,NAME,...=FROM:TO for quantities with equal values, with FROM < TO for each
/// text. Throws InputError, also if a name occurs twice.
std::vector<FreeValue> parse_free_values(const std::vector<std::string>& texts);

/// Parses NAME=:MAX, NAME=MIN: or NAME=MIN:MAX. Throws InputError, also if a name occurs twice.
std::vector<Constraint> parse_constraints(const std::vector<std::string>& texts);

}  // namespace beadswim
