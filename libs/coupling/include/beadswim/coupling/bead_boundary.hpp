#pragma once

#include <span>
#include <vector>

#include "beadswim/coupling/bead_links.hpp"
#include "beadswim/coupling/bead_on_lattice.hpp"
#include "beadswim/coupling/coverage.hpp"
#include "beadswim/coupling/link_sums.hpp"
#include "beadswim/lattice/populations.hpp"
#include "beadswim/lattice/trt.hpp"

// Loops over links (lines from a fluid cell to a cell that a bead covers) and over cells that beads cover or
// uncover, on the block of one rank. The equations for a single link are in moving_bounce_back.hpp,
// interpolated_bounce_back.hpp and multireflection.hpp.

namespace beadswim {

/// Beads and their links on the block of one rank, for one time step of the fluid.
struct BeadBoundary {
  const Coverage& coverage;
  BeadLinks& links;
  std::span<const BeadOnLattice> beads;
  const RelaxationRates& rates;  ///< rates of the fluid
  std::vector<LinkSums>& sums;   ///< one per bead

  /// Bounces populations back at all links that must be processed before plane z of the block is swept
  /// (BeadLinks). Adds the impulses on the beads to `sums`. step_fluid() must call this function before each
  /// plane, in the order in which it sweeps the planes. The links then need only halo cells that are already
  /// filled.
  void bounce_back_before_plane(Populations& populations, int z);
};

/// Evaluates the returned mass: the fluid mass that each link of a bead returns to the fluid in one step,
/// divided by the weight w_i of the link. held_mass: fluid mass beyond density 1 that the bead has taken up.
/// link_weight: sum of w_i over all links of the bead; 0 if the bead has no links.
///
/// The bead returns a tenth of held_mass per step, in proportion to the weights w_i. The returned mass
/// changes the mass that interpolated links take up in the following steps. If the bead returned all of
/// held_mass in one step, held_mass would therefore change its sign and grow from step to step.
constexpr double returned_mass(double held_mass, double link_weight) {
  constexpr double returned_part = 0.1;
  return link_weight > 0 ? returned_part * held_mass / link_weight : 0;
}

/// Adds the impulse, angular impulse, fluid mass and link weight that each bead has received from its links
/// in one step (`sums`, one entry per bead) to BeadOnLattice::impulse. Resets `sums` to zero.
void transfer_impulses(std::span<LinkSums> sums, std::span<BeadOnLattice> beads);

/// Transfers mass and momentum between beads and fluid in the cells that the last Coverage::update() has
/// changed. A bead takes up the momentum and mass of the fluid in newly covered cells. Uncovered cells are
/// refilled with fluid (refill.hpp), and the bead loses the momentum and mass that they receive (Aidun, Lu &
/// Ding 1998, section 3.3).
/// - `beads`: beads of the last update
/// - `beads_before`, `links_before`: beads and links of the update before it
/// - `rates`: relaxation rates of the fluid
///
/// Throws FaultError if a bead that has uncovered cells is no longer in `beads`, because it moved too far
/// from the block in one step.
void transfer_changed_cells(Populations& populations, const Coverage& coverage, const BeadLinks& links_before,
                            std::span<const BeadOnLattice> beads_before, std::span<BeadOnLattice> beads,
                            const RelaxationRates& rates);

}  // namespace beadswim
