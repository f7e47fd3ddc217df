#pragma once

#include <algorithm>
#include <vector>

namespace beadswim {

/// Returns the median. For an even number of values it is the mean of the middle two. `values` must not be
/// empty.
inline double median(std::vector<double> values) {
  std::ranges::sort(values);
  const std::size_t n = values.size();
  return n % 2 == 1 ? values[n / 2] : 0.5 * (values[n / 2 - 1] + values[n / 2]);
}

}  // namespace beadswim
