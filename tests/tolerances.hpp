#pragma once

#include <limits>

namespace beadswim {

/// Returns an upper bound of the error that this number of rounding operations with numbers of order one can
/// cause.
constexpr double roundoff(double operations) {
  return operations * std::numeric_limits<double>::epsilon();
}

}  // namespace beadswim
