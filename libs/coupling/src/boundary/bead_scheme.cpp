#include "beadswim/coupling/bead_scheme.hpp"

#include "beadswim/core/error.hpp"

namespace beadswim {

std::string name_of(BeadScheme scheme) {
  switch (scheme) {
    case BeadScheme::staircase:
      return "staircase";
    case BeadScheme::cli:
      return "cli";
    case BeadScheme::mr:
      return "mr";
    case BeadScheme::psm:
      return "psm";
  }
  return "";
}

std::vector<std::string> bead_scheme_names() {
  std::vector<std::string> names;
  for (const BeadScheme scheme : all_bead_schemes) names.push_back(name_of(scheme));
  return names;
}

BeadScheme bead_scheme_named(const std::string& name) {
  for (const BeadScheme scheme : all_bead_schemes) {
    if (name_of(scheme) == name) return scheme;
  }
  throw InputError("no bead boundary scheme is called '" + name + "'");
}

}  // namespace beadswim
