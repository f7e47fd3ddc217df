#pragma once

#include "beadswim/core/setting.hpp"

namespace beadswim {

/// The flag that sets what libraries call a setting.
std::string flag_of(Setting setting);

}  // namespace beadswim
