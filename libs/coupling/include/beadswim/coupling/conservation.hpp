#pragma once

#include <optional>

#include "beadswim/coupling/fault.hpp"
#include "beadswim/coupling/scene.hpp"

namespace beadswim {

/// Totals of the complete scene, in lattice units.
struct SceneTotals {
  Vec3 momentum = Vec3::Zero();  ///< momentum of fluid and beads, with impulses not yet applied to the beads
  /// Mean velocity over the volume of the box. Cells within a bead count with the velocity of the bead.
  Vec3 mean_flow = Vec3::Zero();
  /// Sum of (density - 1) over the fluid cells, plus the fluid mass that the beads have taken up and not yet
  /// returned; divided by the number of cells.
  double mass_excess = 0;

  static void visit_fields(auto&& visit, auto& totals) {
    visit("momentum", totals.momentum);
    visit("mean_flow", totals.mean_flow);
    visit("mass_excess", totals.mass_excess);
  }
};

/// Returns a fault if a conserved total has changed by more than roundoff can explain, or is non-finite. The
/// mass is conserved; in a box that is periodic along all axes, the momentum also is. The change of momentum
/// is divided by the momentum of all beads at `bead_speed`, the largest speed of any bead so far [cell/step].
/// Fault::step is not set.
///
/// The limits in conservation.cpp are far larger than roundoff. Six cycles of the swimmer of Pickl et al.
/// 2017 at 2 cells per radius changed the momentum by a relative 2e-15, and the mass not at all, in double
/// precision. In single precision the relative changes were 4e-7 (momentum) and 2e-11 (mass).
std::optional<Fault> conservation_fault(const CoupledScene& scene, const SceneTotals& first,
                                        const SceneTotals& now, double bead_speed);

}  // namespace beadswim
