#pragma once

#include "beadswim/core/order_free_lanes.hpp"

namespace beadswim {

/// What a cell hands to a bead: impulse (3), angular impulse (3), and the momentum (3) and angular momentum
/// (3) of the fluid within the bead.
constexpr int saturated_terms = 12;

/// Sums over the cells of one bead in a step.
using SaturatedSums = OrderFreeLanes<saturated_terms>;

}  // namespace beadswim
