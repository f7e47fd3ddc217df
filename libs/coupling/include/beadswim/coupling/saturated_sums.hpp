#pragma once

#include "beadswim/core/order_free_lanes.hpp"

namespace beadswim {

/// Number of terms that a saturated cell contributes to a bead: impulse and angular impulse on the bead,
/// momentum and angular momentum of the fluid within the bead, 3 components each.
constexpr int saturated_terms = 12;

/// Sums over the saturated cells of one bead in one step: impulse and angular impulse on the bead, momentum
/// and angular momentum of the fluid within the bead.
using SaturatedSums = OrderFreeLanes<saturated_terms>;

}  // namespace beadswim
