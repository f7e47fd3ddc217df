#pragma once

#include <span>
#include <vector>

#include "beadswim/coupling/bead_links.hpp"
#include "beadswim/coupling/bead_on_lattice.hpp"
#include "beadswim/coupling/coverage.hpp"
#include "beadswim/coupling/link_sums.hpp"
#include "beadswim/lattice/populations.hpp"
#include "beadswim/lattice/trt.hpp"

// The loops over links and changing cells; the laws are in moving_bounce_back.hpp and
// interpolated_bounce_back.hpp. Each works on one rank's block.

namespace beadswim {

/// Beads and their links in one step of the fluid.
struct BeadBoundary {
  const Coverage& coverage;
  BeadLinks& links;
  std::span<const BeadOnLattice> beads;
  const RelaxationRates& rates;  ///< of the fluid
  std::vector<LinkSums>& sums;   ///< one a bead

  /// Bounces populations back at the links that belong to row (y, z) of the block, and adds up what they hand
  /// to the beads. For step_fluid() to call, before each row and in its order: links need no more of the halo
  /// than is filled then.
  void bounce_back_before_row(Populations& populations, int y, int z);
};

/// Fluid mass that each link of a bead returns in a step, over its weight w_i: of what the bead has come to
/// hold a tenth, alike in all directions; link_weight: sum of w_i over the links, which a bead may lack. What
/// links return changes what interpolated ones take in the next steps: all of it at once makes that
/// overshoot, and grow.
constexpr double returned_mass(double held_mass, double link_weight) {
  constexpr double returned_part = 0.1;
  return link_weight > 0 ? returned_part * held_mass / link_weight : 0;
}

/// Adds the sums over a step to the beads' impulses, and starts them anew.
void hand_over_impulses(std::span<LinkSums> sums, std::span<BeadOnLattice> beads);

/// What changes hands in the last update of the coverage. A bead takes over momentum and mass of the fluid
/// that it covers; a cell that it uncovers is filled (refill.hpp), and the bead gives up as much (Aidun, Lu &
/// Ding 1998, section 3.3). `beads`: those of the update; `beads_before` and `links_before`: those of the
/// update before. `rates`: of the fluid.
void hand_over_changed_cells(Populations& populations, const Coverage& coverage,
                             const BeadLinks& links_before, std::span<const BeadOnLattice> beads_before,
                             std::span<BeadOnLattice> beads, const RelaxationRates& rates);

}  // namespace beadswim
