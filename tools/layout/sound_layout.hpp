#pragma once

#include <string>

#include "beadswim/core/error.hpp"
#include "beadswim/scene/check.hpp"

namespace beadswim {

/// Throws InputError with the first fault of a layout that `makers` ("the flags") made, and what may help.
inline void require_sound(const Layout& layout, const std::string& makers, const std::string& remedy = "") {
  const auto faults = check_layout(layout);
  if (faults.empty()) return;
  throw InputError(makers + " make no sound layout",
                   faults.front().place + ": " + faults.front().message + remedy);
}

}  // namespace beadswim
