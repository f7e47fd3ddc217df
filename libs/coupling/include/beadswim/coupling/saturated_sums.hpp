#pragma once

#include "beadswim/core/order_free_lanes.hpp"

namespace beadswim {

/// Number of terms that a cell contributes to a bead, 3 components each: impulse and angular impulse on the
/// bead, momentum and angular momentum of the fluid within the bead.
constexpr int saturated_terms = 12;

/// Sums over the cells of one bead in one step.
using SaturatedSums = OrderFreeLanes<saturated_terms>;

}  // namespace beadswim
