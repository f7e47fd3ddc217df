#pragma once

#include <span>
#include <vector>

#include "beadswim/coupling/bead_links.hpp"
#include "beadswim/coupling/bead_on_lattice.hpp"
#include "beadswim/coupling/coverage.hpp"
#include "beadswim/coupling/link_sums.hpp"
#include "beadswim/lattice/populations.hpp"
#include "beadswim/lattice/trt.hpp"

// Loops over links and over cells that beads cover or uncover, on the block of one rank. The laws of a single
// link are in moving_bounce_back.hpp, interpolated_bounce_back.hpp and multireflection.hpp.

namespace beadswim {

/// Beads and their links in one step of the fluid.
struct BeadBoundary {
  const Coverage& coverage;
  BeadLinks& links;
  std::span<const BeadOnLattice> beads;
  const RelaxationRates& rates;  ///< rates of the fluid
  std::vector<LinkSums>& sums;   ///< one per bead

  /// Bounces populations back at the links that belong to row (y, z) of the block, and adds the impulses on
  /// the beads to `sums`. step_fluid() must call it before each row, in the order of the rows: the links then
  /// need only halo cells that are already filled.
  void bounce_back_before_row(Populations& populations, int y, int z);
};

/// Evaluates the fluid mass that each link of a bead returns in a step, divided by the weight w_i of the
/// link. The bead returns a tenth of the mass that it holds, equally in all directions. link_weight: sum of
/// w_i over the links; 0 if the bead has no links. The returned mass changes the mass that interpolated links
/// take up in the following steps. Returning the complete mass in one step would therefore overshoot and
/// grow.
constexpr double returned_mass(double held_mass, double link_weight) {
  constexpr double returned_part = 0.1;
  return link_weight > 0 ? returned_part * held_mass / link_weight : 0;
}

/// Adds the sums over a step to the impulses of the beads and resets the sums.
void transfer_impulses(std::span<LinkSums> sums, std::span<BeadOnLattice> beads);

/// Transfers mass and momentum in the cells that the last update of the coverage changed. A bead takes over
/// momentum and mass of the fluid in newly covered cells. Uncovered cells are refilled (refill.hpp), and the
/// bead loses the momentum and mass that they receive (Aidun, Lu & Ding 1998, section 3.3). `beads`: beads of
/// this update; `beads_before` and `links_before`: beads and links of the previous update; `rates`: rates of
/// the fluid. Throws FaultError if a bead that uncovers cells has left the surroundings of the block.
void transfer_changed_cells(Populations& populations, const Coverage& coverage, const BeadLinks& links_before,
                            std::span<const BeadOnLattice> beads_before, std::span<BeadOnLattice> beads,
                            const RelaxationRates& rates);

}  // namespace beadswim
