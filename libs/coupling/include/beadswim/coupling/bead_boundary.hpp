#pragma once

#include <span>

#include "beadswim/coupling/bead_on_lattice.hpp"
#include "beadswim/coupling/coverage.hpp"
#include "beadswim/lattice/populations.hpp"

// The loops over links and covered cells; the laws are in moving_bounce_back.hpp. Each works on one rank's
// block.

namespace beadswim {

/// Bounces populations back at every link between a fluid cell and a covered one, and adds the links'
/// momentum to the beads' impulses; notes the density around each covered cell. The halo must have been
/// filled.
void bounce_back_at_beads(Populations& populations, Coverage& coverage, std::span<BeadOnLattice> beads);

/// Sets own covered cells to equilibrium at their bead's velocity and the density around them.
void reset_covered_cells(Populations& populations, const Coverage& coverage,
                         std::span<const BeadOnLattice> beads);

/// What changes hands as `before` gives way to `now`: a bead takes over momentum and mass of the fluid that
/// it covers, and leaves behind those of the cells that it uncovers (Aidun, Lu & Ding 1998, section 3.3).
/// `beads`: those of `now`; `before_beads`: those of `before`.
void hand_over_changed_cells(const Populations& populations, const Coverage& before,
                             std::span<const BeadOnLattice> before_beads, const Coverage& now,
                             std::span<BeadOnLattice> beads);

}  // namespace beadswim
