#pragma once

#include <limits>

namespace beadswim {

/// What `operations` roundings of numbers of order one may add up to.
constexpr double roundoff(double operations) {
  return operations * std::numeric_limits<double>::epsilon();
}

}  // namespace beadswim
