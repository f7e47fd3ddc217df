#pragma once

#include <string>
#include <vector>

#include "beadswim/core/communicator.hpp"
#include "bench_case.hpp"

namespace beadswim {

/// Times all cases in turn, round after round, so that a drift of the machine meets all alike. Collective.
/// Returns the seconds of one step, [case][round], on every rank.
std::vector<std::vector<double>> time_in_rounds(const std::vector<BenchCase>& cases, int rounds,
                                                const Communicator& communicator);

}  // namespace beadswim
