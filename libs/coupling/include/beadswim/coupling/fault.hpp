#pragma once

#include <optional>

#include "beadswim/core/communicator.hpp"
#include "beadswim/core/error.hpp"
#include "beadswim/coupling/bead_on_lattice.hpp"

namespace beadswim {

/// What may go wrong in a run; of two things in one step the first here is told.
enum class FaultKind {
  not_finite,  ///< no number any more, or far too large a one
  speed,       ///< a bead's surface over the paper's limit [cell/step]
  torn_arm,    ///< an arm over twice its rest length [rest length]
  wall,        ///< a bead at a wall, or beyond it [cell from its surface]
  overlap,     ///< beads too deep in each other [smaller radius]
  mass,        ///< of fluid and beads, lost [of all]
  momentum,    ///< likewise, in a periodic box [of the beads' at their largest speed]
};

/// Something that went wrong. In lattice units.
struct Fault {
  FaultKind kind = FaultKind::not_finite;
  long step = 0;
  BeadName bead{.swimmer = -1, .bead = 0};  ///< swimmer < 0: not known
  BeadName other{.swimmer = -1, .bead = 0};
  Vec3 position = Vec3::Zero();  ///< of the bead
  double value = 0;              ///< as the kind says

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

/// Whether `a` is the one to tell: by step, kind, bead, other bead, and size.
bool comes_before(const Fault& a, const Fault& b);

/// The first of the ranks' faults, the same on all ranks. On any number of them, too, but for the bead that
/// meets what is no number, and for what such a bead drags along in the same step. Collective.
std::optional<Fault> first_fault(const std::optional<Fault>& own, const Communicator& communicator);

/// A number of a bead that is none any more; for the one rank that comes upon it.
class FaultError : public SolverError {
 public:
  explicit FaultError(const Fault& fault) : SolverError("a fault of the run"), fault(fault) {}
  Fault fault;
};

inline FaultError not_finite_at(const BeadOnLattice& bead) {
  return FaultError({.kind = FaultKind::not_finite, .bead = bead.name, .position = bead.motion.position});
}

}  // namespace beadswim
