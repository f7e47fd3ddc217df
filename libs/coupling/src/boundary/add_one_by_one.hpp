#pragma once

#include "beadswim/coupling/fault.hpp"

namespace beadswim {

/// Adds a bead's terms that are too large for lanes one by one: there is more room there. Batch: terms[t][k],
/// k < count; Sums: sums[t]. Throws FaultError where even that does not suffice, or a term is no number.
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
