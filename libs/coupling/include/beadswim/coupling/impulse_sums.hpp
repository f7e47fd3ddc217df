#pragma once

#include "beadswim/core/order_free_lanes.hpp"

// Sums of the contributions of links and cells to one bead in one step. The kernels add to them.

namespace beadswim {

/// Number of terms that a link contributes to its bead: impulse (3 components), angular impulse (3
/// components), fluid mass (1) and weight of the link (1).
constexpr int link_terms = 8;
using LinkSums = OrderFreeLanes<link_terms>;

/// Number of terms that a saturated cell contributes to a bead: impulse and angular impulse on the bead,
/// momentum and angular momentum of the fluid within the bead, 3 components each.
constexpr int saturated_terms = 12;
using SaturatedSums = OrderFreeLanes<saturated_terms>;

}  // namespace beadswim
