#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "beadswim/core/error.hpp"
#include "beadswim/coupling/bead_scheme.hpp"

namespace beadswim::verification {

inline std::vector<std::string> scheme_names() {
  std::vector<std::string> names;
  for (const BeadScheme scheme : all_bead_schemes) names.push_back(name_of(scheme));
  return names;
}

/// Throws InputError for a name that no scheme has.
inline BeadScheme scheme_of(const std::string& name) {
  for (const BeadScheme scheme : all_bead_schemes) {
    if (name_of(scheme) == name) return scheme;
  }
  throw InputError("no bead boundary scheme is called '" + name + "'");
}

}  // namespace beadswim::verification
