#pragma once

#include <string>
#include <vector>

#include "beadswim/scene/layout.hpp"

// Parameters of swimmers as text for figures.

namespace beadswim {

/// Returns the parameters of the driving: "A = B = 2, α = 1.571 rad, T = 2000, along x", or, if it is not the
/// driving of the paper's swimmer, "3 drives, T = 1000".
std::string driving_parameters(const Driving& driving);

/// Returns one line per type of the layout, with the number of swimmers that have their own driving. Returns
/// at most four lines.
std::vector<std::string> type_notes(const Layout& layout);

}  // namespace beadswim
