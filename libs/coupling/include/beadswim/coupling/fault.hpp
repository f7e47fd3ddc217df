#pragma once

#include <optional>

#include "beadswim/core/communicator.hpp"
#include "beadswim/core/error.hpp"
#include "beadswim/core/order_free_lanes.hpp"
#include "beadswim/coupling/bead_on_lattice.hpp"
#include "beadswim/scene/fault.hpp"

namespace beadswim {

/// Returns the first fault of all ranks, the same on all ranks. The result does not depend on the number of
/// ranks, with one exception. If a number is non-finite, the bead to which it is attributed can depend on the
/// number of ranks, and so can the faults that it causes in the same step. Collective.
std::optional<Fault> first_fault(const std::optional<Fault>& own, const Communicator& communicator);

/// Exception that a rank throws when it finds a non-finite number of a bead.
class FaultError : public SolverError {
 public:
  explicit FaultError(const Fault& fault) : SolverError("a fault of the run"), fault(fault) {}
  Fault fault;
};

inline FaultError not_finite_at(const BeadOnLattice& bead) {
  return FaultError({.kind = FaultKind::not_finite, .bead = bead.name, .position = bead.motion.position});
}

/// Adds the terms terms[t][k], k < count, to the sums of a bead: one by one, for each quantity t to
/// sums.sums[t]. This accepts larger terms than the vectorised addition in the kernels. Throws FaultError if
/// a term is non-finite or too large for OrderFreeSum.
template <int N, int capacity>
void add_one_by_one(const double (&terms)[N][capacity], int count, OrderFreeLanes<N>& sums,
                    const BeadOnLattice& bead) {
  try {
    for (int t = 0; t < N; ++t) {
      for (int k = 0; k < count; ++k) sums.sums[t].add(terms[t][k]);
    }
  } catch (const SolverError&) {
    throw not_finite_at(bead);
  }
}

}  // namespace beadswim
