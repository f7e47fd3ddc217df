#pragma once

#include <string>
#include <vector>

#include "beadswim/scene/layout.hpp"

// Parameters of swimmers in words, as figures note them.

namespace beadswim {

/// "λ = 6, bead density 1, l = 32, k = 0.2, KA = 2048": beads and springs; dashpots where there are any.
/// Lists of different values are joined by commas.
std::string body_parameters(const SwimmerType& type);

/// "A = B = 2, α = 1.571 rad, T = 2000, along x": the driving forces.
std::string driving_parameters(const Driving& driving);

/// A line on each type of the layout's swimmers, at most so many.
std::vector<std::string> type_notes(const Layout& layout);

}  // namespace beadswim
