#include "beadswim/core/version.hpp"

#include "revision.hpp"

namespace beadswim {

std::string version() {
  return BEADSWIM_VERSION;
}
std::string revision() {
  return BEADSWIM_REVISION;
}

}  // namespace beadswim
