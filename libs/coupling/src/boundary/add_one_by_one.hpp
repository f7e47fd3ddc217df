#pragma once

#include "beadswim/coupling/fault.hpp"

namespace beadswim {

/// Adds the terms batch.terms[t][k], k < count, to the sums of a bead: one by one, for each quantity t to
/// sums.sums[t]. This accepts larger terms than the vectorised addition in the kernels. Throws FaultError if
/// a term is non-finite or too large for OrderFreeSum.
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
