#pragma once

#include <string>

#include "beadswim/core/error.hpp"
#include "beadswim/scene/check.hpp"

namespace beadswim {

/// Throws InputError with the first error that check_layout() finds in the layout. `source`: origin of the
/// layout for the message, a plural such as "the flags". `remedy`: text at the end of the message.
inline void require_sound(const Layout& layout, const std::string& source, const std::string& remedy = "") {
  const auto faults = check_layout(layout);
  if (faults.empty()) return;
  throw InputError("the layout made by " + source + " is invalid",
                   faults.front().place + ": " + faults.front().message + remedy);
}

}  // namespace beadswim
