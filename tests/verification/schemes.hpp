#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "beadswim/core/error.hpp"
#include "beadswim/coupling/bead_scheme.hpp"

namespace beadswim::verification {

/// The one list of bead boundary schemes here: a new one is verified once it stands in it.
constexpr std::array all_schemes{BeadScheme::staircase, BeadScheme::cli, BeadScheme::mr, BeadScheme::psm};

inline std::vector<std::string> scheme_names() {
  std::vector<std::string> names;
  for (const BeadScheme scheme : all_schemes) names.push_back(name_of(scheme));
  return names;
}

/// Throws InputError for a name that no scheme has.
inline BeadScheme scheme_of(const std::string& name) {
  for (const BeadScheme scheme : all_schemes) {
    if (name_of(scheme) == name) return scheme;
  }
  throw InputError("no bead boundary scheme is called '" + name + "'");
}

}  // namespace beadswim::verification
