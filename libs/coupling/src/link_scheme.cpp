#include "beadswim/coupling/link_scheme.hpp"

namespace beadswim {

std::string name_of(LinkScheme scheme) {
  if (scheme == LinkScheme::psm) return "psm";
  return scheme == LinkScheme::staircase ? "staircase" : "cli";
}

}  // namespace beadswim
