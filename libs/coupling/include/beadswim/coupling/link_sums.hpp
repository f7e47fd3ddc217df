#pragma once

#include "beadswim/core/order_free_lanes.hpp"

namespace beadswim {

/// Terms that a link contributes to its bead: impulse (3), angular impulse (3), mass, weight of the link.
constexpr int link_terms = 8;

/// Sums over the links of one bead in a step.
using LinkSums = OrderFreeLanes<link_terms>;

}  // namespace beadswim
