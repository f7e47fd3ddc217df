#pragma once

#include "beadswim/coupling/fault.hpp"

namespace beadswim {

/// Adds the terms of a bead one by one to its order-free sums, whose range is larger than that of the lanes.
/// Batch: terms[t][k], k < count; Sums: sums[t]. Throws FaultError if a term is too large for the sums or
/// non-finite.
template <class Batch, class Sums>
void add_one_by_one(const Batch& batch, int count, Sums& sums, const BeadOnLattice& bead) {
  try {
    for (std::size_t t = 0; t < sums.sums.size(); ++t) {
      for (int k = 0; k < count; ++k) sums.sums[t].add(batch.terms[t][k]);
    }
  } catch (const SolverError&) {
    throw not_finite_at(bead);
  }
}

}  // namespace beadswim
