#pragma once

#include <string>

namespace beadswim {

/// The processor's name as the system has it; "unknown" where it has none.
std::string processor_name();

}  // namespace beadswim
