#pragma once

#include <optional>

#include "beadswim/coupling/fault.hpp"
#include "beadswim/coupling/scene.hpp"

namespace beadswim {

/// Sums over the whole scene, in lattice units.
struct SceneTotals {
  Vec3 momentum = Vec3::Zero();   ///< of fluid and beads, and of impulses under way between them
  Vec3 mean_flow = Vec3::Zero();  ///< volume mean of the velocity, covered cells moving with their bead
  /// Mass of the fluid, and of what beads hold of it, beyond density 1, relative to the mass of a box of
  /// fluid.
  double mass_excess = 0;

  static void visit_fields(auto&& visit, auto& totals) {
    visit("momentum", totals.momentum);
    visit("mean_flow", totals.mean_flow);
    visit("mass_excess", totals.mass_excess);
  }
};

/// Whether mass, or momentum in a periodic box, has changed by more than roundoff explains, or is no number;
/// momentum relative to that of all beads at `bead_speed`, the largest so far [cell/step]. Six cycles of the
/// paper's swimmer at 2 cells a radius lost 2e-15 of momentum and no mass in double precision, 4e-7 and 2e-11
/// in single; the limits are far beyond. The fault's step is not set.
std::optional<Fault> conservation_fault(const CoupledScene& scene, const SceneTotals& first,
                                        const SceneTotals& now, double bead_speed);

}  // namespace beadswim
