#pragma once

#include <optional>

#include "beadswim/coupling/fault.hpp"
#include "beadswim/coupling/scene.hpp"

namespace beadswim {

/// Momentum, mean flow and mass of the complete scene, summed over all ranks, in lattice units.
struct SceneTotals {
  Vec3 momentum = Vec3::Zero();  ///< momentum of fluid, beads and impulses not yet applied to the beads
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

/// Returns a fault if mass or momentum has changed by more than roundoff can explain since the totals
/// `first`, or if one of them is non-finite in the totals `now`. The mass is conserved. The momentum is
/// conserved in a box that is periodic along all axes. The change of momentum is divided by the momentum of
/// all beads at `bead_speed`, the largest speed of any bead so far [cell/step]. Fault::step is not set.
///
/// The limits in conservation.cpp are far larger than roundoff. Six cycles of the swimmer of Pickl et al.
/// 2017 at 2 cells per radius, in double precision, changed the momentum by 2e-15 of the momentum of the
/// beads at their largest speed. The mass did not change. In single precision the changes were 4e-7 for
/// momentum and, relative to the mass of the fluid, 2e-11 for mass.
std::optional<Fault> conservation_fault(const CoupledScene& scene, const SceneTotals& first,
                                        const SceneTotals& now, double bead_speed);

}  // namespace beadswim
