#pragma once

#include "beadswim/study/quantity.hpp"

namespace beadswim {

/// A variation, and quantities that follow it with the same value (sign 1) or the opposite one (sign -1).
struct CoupledVariation {
  Variation first;
  std::vector<std::pair<std::string, double>> others{};
};

/// Parses NAMES=FROM:TO:COUNT, NAMES=FROM:TO:COUNT:log or NAMES=VALUE,VALUE,... with one name or several,
/// joined by commas, those of opposite value after a minus sign. A value of several numbers is [X,Y,...].
/// Throws InputError with the nearest name if one names no quantity.
CoupledVariation parse_variation(const std::string& text);

/// Two quantities whose sum, product or ratio stays the same: when one of them varies, the other follows.
struct KeptRelation {
  std::string first, second;
  char sign = '+';  ///< '+', '*' or ':'
};

/// Parses A+B, A*B or A:B.
KeptRelation parse_relation(const std::string& text);

/// Throws InputError if the variations, which change together, have different numbers of values.
void require_equal_counts(const std::vector<Variation>& variations);

}  // namespace beadswim
