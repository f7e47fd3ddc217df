#pragma once

#include "beadswim/core/order_free_lanes.hpp"

namespace beadswim {

/// Number of terms that a link contributes to its bead: impulse (3 components), angular impulse (3
/// components), fluid mass (1) and weight of the link (1).
constexpr int link_terms = 8;

/// Sums over the links of one bead in one step: impulse, angular impulse, fluid mass and weight.
using LinkSums = OrderFreeLanes<link_terms>;

}  // namespace beadswim
