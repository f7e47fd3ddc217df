#include "beadswim/coupling/bead_scheme.hpp"

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

}  // namespace beadswim
