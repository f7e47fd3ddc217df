#pragma once

#include <vector>

#include "beadswim/core/communicator.hpp"
#include "beadswim/coupling/bead_scheme.hpp"
#include "bench_report.hpp"

namespace beadswim {

struct BenchRequest {
  std::vector<int> edges{64, 128, 256};
  std::vector<Precision> precisions{Precision::fp64, Precision::fp32};
  int rounds = 9;
  BeadScheme bead_boundary = BeadScheme::staircase;  ///< of the swarm
};

/// Measures everything that was asked for, on one rank and on all. Tells its progress on stderr. The report
/// is on rank 0. Throws InputError alike on all ranks if an edge needs more memory than there is.
BenchReport measure_all(const BenchRequest& request, const Communicator& world);

}  // namespace beadswim
