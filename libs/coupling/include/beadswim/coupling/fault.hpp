#pragma once

#include <optional>

#include "beadswim/core/communicator.hpp"
#include "beadswim/core/error.hpp"
#include "beadswim/core/order_free_lanes.hpp"
#include "beadswim/coupling/bead_on_lattice.hpp"

namespace beadswim {

/// Kind of a fault, an unphysical state that ends a run. Square brackets give the unit of Fault::value. If
/// several faults occur in one step, the kind that comes first in this list is reported.
enum class FaultKind {
  not_finite,  ///< a number of the state is non-finite or far too large
  speed,       ///< the surface of a bead moves faster than speed_limit [cell/step]
  torn_arm,    ///< an arm is longer than max_stretch [rest length]
  wall,        ///< the gap between a bead and a wall is smaller than min_wall_gap [cell]
  level,       ///< the gap between a bead and a coarser level is smaller than min_level_gap [cell]
  overlap,     ///< two beads overlap by more than max_overlap [radius of the smaller bead]
  mass,        ///< the total mass of fluid and beads has changed [total mass of the fluid]
  /// The total momentum of fluid and beads in a periodic box has changed [total momentum of the beads if all
  /// of them move at the largest speed so far].
  momentum,
};

/// An unphysical state that ends a run, in lattice units.
struct Fault {
  FaultKind kind = FaultKind::not_finite;
  long step = 0;
  BeadName bead{.swimmer = -1, .bead = 0};  ///< swimmer < 0: no bead is known
  BeadName other{.swimmer = -1, .bead = 0};
  Vec3 position = Vec3::Zero();  ///< centre of the bead
  double value = 0;              ///< quantity that violates its limit; unit: see FaultKind

  static void visit_fields(auto&& visit, auto& fault) {
    visit("kind", fault.kind);
    visit("step", fault.step);
    visit("bead", fault.bead);
    visit("other", fault.other);
    visit("position", fault.position);
    visit("value", fault.value);
  }

  bool names_bead() const { return bead.swimmer >= 0; }
};

/// Returns true if fault `a` is reported in preference to fault `b`. Compares step, kind, bead, other bead
/// and value, in this order. The fault with the smaller entry comes first; for values, the fault with the
/// larger value.
bool comes_before(const Fault& a, const Fault& b);

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
