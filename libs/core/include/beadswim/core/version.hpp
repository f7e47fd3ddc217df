#pragma once

#include <string>

namespace beadswim {

std::string version();   ///< returns the version, for example "0.1.0"
std::string revision();  ///< returns the git revision at build time, or "unknown"

/// Returns the processor's model name as the operating system reports it, or "unknown".
std::string processor_name();

}  // namespace beadswim
