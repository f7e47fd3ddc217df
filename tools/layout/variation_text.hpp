#pragma once

#include "beadswim/study/quantity.hpp"

namespace beadswim {

/// Parses NAME=FROM:TO:COUNT, NAME=FROM:TO:COUNT:log or NAME=VALUE,VALUE,... Throws InputError with the
/// nearest name if NAME names no quantity.
Variation parse_variation(const std::string& text);

/// Throws InputError if the variations, which change together, have different numbers of values.
void require_equal_counts(const std::vector<Variation>& variations);

}  // namespace beadswim
