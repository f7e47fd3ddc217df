#pragma once

#include <optional>
#include <tuple>

#include "beadswim/core/fields.hpp"
#include "beadswim/core/vec3.hpp"
#include "beadswim/swimmers/swimmer_type.hpp"

namespace beadswim {

/// Identifies a bead in the scene.
struct BeadName {
  int swimmer = 0;  ///< id of the swimmer
  int bead = 0;     ///< index of the bead in its swimmer

  auto operator<=>(const BeadName&) const = default;
};

/// Kind of a fault, an unphysical state that ends a run. Square brackets give the unit of Fault::value;
/// lengths are in the unit of the run. If several faults occur in one step, the kind that comes first in this
/// list is reported.
enum class FaultKind {
  not_finite,    ///< a number of the state is non-finite or far too large
  speed,         ///< lattice: the surface of a bead moves faster than speed_limit [cell/step]
  displacement,  ///< mobility: a bead moves by more than its radius in a step, relative to the flow [radius]
  torn_arm,      ///< an arm is longer than max_stretch [rest length]
  wall,          ///< lattice: the gap between a bead and a wall is smaller than min_wall_gap [cell]
  beyond_wall,   ///< mobility: the centre of a bead is beyond a wall of the box [length]
  in_wall,       ///< mobility: a bead overlaps the wall of a half-space [radius]
  level,         ///< the gap between a bead and a coarser level is smaller than min_level_gap [cell]
  overlap,       ///< two beads overlap by more than max_overlap [radius of the smaller bead]
  mass,          ///< the total mass of fluid and beads has changed [total mass of the fluid]
  /// The total momentum of fluid and beads in a periodic box has changed [total momentum of the beads if all
  /// of them move at the largest speed so far].
  momentum,
  not_positive,   ///< model oseen: the mobility is not positive definite; bead: moves most against forces
  not_converged,  ///< mobility: the linear solver of a step did not converge
};

/// An unphysical state that ends a run, in the units of the run.
struct Fault {
  FaultKind kind = FaultKind::not_finite;
  long step = 0;                            ///< number of the step with the fault, from 1
  BeadName bead{.swimmer = -1, .bead = 0};  ///< swimmer < 0: no bead is known
  BeadName other{.swimmer = -1, .bead = 0};
  Vec3 position = Vec3::Zero();  ///< centre of the bead; in mobility runs before the step
  double value = 0;              ///< quantity that violates its limit; unit: see FaultKind

  BEADSWIM_FIELDS(kind, step, bead, other, position, value)

  bool names_bead() const { return bead.swimmer >= 0; }
};

/// Returns true if fault `a` is reported in preference to fault `b`. Compares step, kind, bead, other bead
/// and value, in this order. The fault with the smaller entry comes first; for values, the fault with the
/// larger value.
inline bool comes_before(const Fault& a, const Fault& b) {
  const auto rank = [](const Fault& f) { return std::tuple(f.step, f.kind, f.bead, f.other, -f.value); };
  return rank(a) < rank(b);
}

/// Replaces `first` by `fault` if there is none yet, or if `fault` is reported in preference to it.
inline void keep_first(std::optional<Fault>& first, const Fault& fault) {
  if (!first || comes_before(fault, *first)) first = fault;
}

/// Returns a fault if an arm of the swimmer with this id is longer than max_stretch. position(b): centre of
/// bead b [length]. Fault::step is not set.
template <class Position>
std::optional<Fault> torn_arm(const SwimmerType& type, int swimmer, const Position& position) {
  for (const Bond& bond : type.bonds) {
    const auto [i, j] = bond.beads;
    const double stretch = (position(j) - position(i)).norm() / bond.rest_length;
    if (stretch <= max_stretch) continue;
    return Fault{.kind = FaultKind::torn_arm,
                 .bead = {swimmer, i},
                 .other = {swimmer, j},
                 .position = position(i),
                 .value = stretch};
  }
  return std::nullopt;
}

}  // namespace beadswim
