#pragma once

#include <functional>
#include <string>
#include <vector>

#include "beadswim/core/communicator.hpp"
#include "beadswim/coupling/bead_scheme.hpp"
#include "beadswim/lattice/precision.hpp"

namespace beadswim {

/// One benchmark case of beadswim-bench. `step` performs one time step of the lattice on this rank, or one
/// pass over arrays that measures the memory.
struct BenchCase {
  std::string name;
  Precision precision = Precision::fp64;
  std::function<void()> step;
  double updates = 0;    ///< cell updates per step, on all ranks together
  std::string layout{};  ///< memory layout of the case stream-yardstick (StreamLayout); empty for others
};

/// Returns all lattice benchmark cases for one cube size, in the order in which each round times them.
/// `edge`: cells per axis of the cube of each rank.
std::vector<BenchCase> lattice_cases(int edge, const std::vector<Precision>& precisions,
                                     BeadScheme bead_boundary, const Communicator& communicator);

/// Returns the memory that the cases need per rank [byte].
double lattice_bytes(int edge, const std::vector<Precision>& precisions);

/// Returns the memory traffic of one cell update [byte]: 19 populations are loaded and 19 are stored.
double bytes_per_update(Precision precision);

}  // namespace beadswim
