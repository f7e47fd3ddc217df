#pragma once

#include "beadswim/core/order_free_lanes.hpp"

namespace beadswim {

/// Terms that a cell contributes to a bead: impulse (3), angular impulse (3), and momentum (3) and angular
/// momentum (3) of the fluid within the bead.
constexpr int saturated_terms = 12;

/// Sums over the cells of one bead in a step.
using SaturatedSums = OrderFreeLanes<saturated_terms>;

}  // namespace beadswim
