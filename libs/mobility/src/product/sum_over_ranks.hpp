#pragma once

#include <span>

#include "beadswim/core/communicator.hpp"

namespace beadswim {

/// Replaces numbers by their sum over all ranks. The sum is always evaluated in the order of the ranks, so
/// its bits depend only on the number of ranks. Collective.
void sum_over_ranks(std::span<double> numbers, const Communicator& communicator);

}  // namespace beadswim
