#pragma once

#include <vector>

#include "beadswim/core/communicator.hpp"
#include "beadswim/coupling/bead_scheme.hpp"
#include "bench_report.hpp"

namespace beadswim {

/// The measurements that the command line requests.
struct BenchRequest {
  std::vector<int> edges{64, 128, 256};  ///< cells per axis and rank
  std::vector<Precision> precisions{Precision::fp64, Precision::fp32};
  int rounds = 9;                                    ///< repetitions of each case
  BeadScheme bead_boundary = BeadScheme::staircase;  ///< scheme of the case coupled-swarm
};

/// Times all requested cases on one rank and on all ranks, and prints the progress to stderr. Only the report
/// on rank 0 is complete. Throws InputError on all ranks if the cubes of an edge need more memory than is
/// free. Collective.
BenchReport measure_all(const BenchRequest& request, const Communicator& world);

}  // namespace beadswim
