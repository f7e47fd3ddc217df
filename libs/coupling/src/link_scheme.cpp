#include "beadswim/coupling/link_scheme.hpp"

namespace beadswim {

std::string name_of(LinkScheme scheme) {
  switch (scheme) {
    case LinkScheme::staircase:
      return "staircase";
    case LinkScheme::cli:
      return "cli";
    case LinkScheme::mr:
      return "mr";
    case LinkScheme::psm:
      return "psm";
  }
  return "";
}

}  // namespace beadswim
