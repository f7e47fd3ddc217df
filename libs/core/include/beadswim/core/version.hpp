#pragma once

#include <string>

namespace beadswim {

std::string version();   ///< "0.1.0"
std::string revision();  ///< git revision at build time, or "unknown"

}  // namespace beadswim
