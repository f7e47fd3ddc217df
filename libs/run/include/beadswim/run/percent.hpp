#pragma once

#include <string>

namespace beadswim {

/// Returns a relative error as text in per cent: two digits below 100 %, no decimals above, and "more than
/// 1000 %" for larger values.
std::string in_percent(double share);

}  // namespace beadswim
