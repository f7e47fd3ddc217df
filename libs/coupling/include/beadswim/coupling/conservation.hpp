#pragma once

#include <optional>

#include "beadswim/coupling/fault.hpp"
#include "beadswim/coupling/scene.hpp"

namespace beadswim {

/// Totals of the complete scene, in lattice units.
struct SceneTotals {
  Vec3 momentum = Vec3::Zero();   ///< of fluid and beads, including pending impulses
  Vec3 mean_flow = Vec3::Zero();  ///< volume mean of the velocity; covered cells move with their bead
  /// Sum of (density - 1) over the fluid, plus the fluid mass that beads hold, divided by the number of
  /// cells.
  double mass_excess = 0;

  static void visit_fields(auto&& visit, auto& totals) {
    visit("momentum", totals.momentum);
    visit("mean_flow", totals.mean_flow);
    visit("mass_excess", totals.mass_excess);
  }
};

/// Returns a fault if the mass, or in a periodic box the momentum, has changed by more than roundoff explains
/// or is non-finite. The change of momentum is divided by the momentum of all beads at `bead_speed`, the
/// largest speed so far [cell/step]. Six cycles of the paper's swimmer at 2 cells per radius lost 2e-15 of
/// the momentum and no mass in double precision, and 4e-7 and 2e-11 in single precision. The limits are far
/// larger. The step of the fault is not set.
std::optional<Fault> conservation_fault(const CoupledScene& scene, const SceneTotals& first,
                                        const SceneTotals& now, double bead_speed);

}  // namespace beadswim
