#pragma once

#include <string>
#include <vector>

#include "beadswim/core/communicator.hpp"
#include "bench_case.hpp"

namespace beadswim {

/// Times all cases once per round, so that slow changes of the speed of the machine affect all cases equally.
/// Returns the time per step of each case in each round, indexed [case][round] [s], on every rank.
/// Collective.
std::vector<std::vector<double>> time_in_rounds(const std::vector<BenchCase>& cases, int rounds,
                                                const Communicator& communicator);

}  // namespace beadswim
