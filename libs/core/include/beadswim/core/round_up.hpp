#pragma once

#include <cstddef>

namespace beadswim {

/// Returns the smallest multiple of `unit` that is not less than `count`. Requires count >= 0 and unit > 0.
constexpr std::ptrdiff_t round_up_to_multiple(std::ptrdiff_t count, std::ptrdiff_t unit) {
  return (count + unit - 1) / unit * unit;
}

}  // namespace beadswim
