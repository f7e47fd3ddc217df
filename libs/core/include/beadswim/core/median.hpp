#pragma once

#include <vector>

namespace beadswim {

/// Returns the median. For an even number of values it is the mean of the middle two. `values` must not be
/// empty.
double median(std::vector<double> values);

}  // namespace beadswim
