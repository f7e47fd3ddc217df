#pragma once

#include <string>

namespace beadswim {

/// Returns the processor's model name as the operating system reports it, or "unknown".
std::string processor_name();

}  // namespace beadswim
