#pragma once

#include "beadswim/core/setting.hpp"

namespace beadswim {

/// Returns the flag with which users set this setting of the libraries, for error messages.
std::string flag_of(Setting setting);

}  // namespace beadswim
