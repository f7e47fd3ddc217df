#pragma once

#include <string>

namespace beadswim {

std::string version();   ///< returns the version, for example "0.1.0"
std::string revision();  ///< returns the git revision at build time, or "unknown"

}  // namespace beadswim
