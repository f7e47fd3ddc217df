#pragma once

#include "beadswim/core/setting.hpp"

namespace beadswim {

/// Returns the flag that sets a setting of the libraries, for messages.
std::string flag_of(Setting setting);

}  // namespace beadswim
