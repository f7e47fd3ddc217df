#pragma once

#include <limits>
#include <optional>
#include <span>

#include "beadswim/swimmers/near_contact.hpp"
#include "beadswim/coupling/bead_on_lattice.hpp"
#include "beadswim/coupling/coverage.hpp"
#include "beadswim/coupling/fault.hpp"
#include "beadswim/coupling/scene.hpp"
#include "beadswim/coupling/swimmer_state.hpp"

// The loop over beads that are close to each other or to periodic images; the law is in
// swimmers/near_contact.hpp. It works on one rank's block.

namespace beadswim {

/// Cut-offs below which the lattice lacks resistance of the film between two beads [cell]: where the
/// resistance that it has, the same at all smaller gaps, is the exact one (docs/verification.md). Beads are
/// rough by a thousandth of the smallest one's radius.
LubricationRange lubrication_range(BeadScheme scheme, double smallest_radius);

/// The scene's law, in lattice units.
NearContactLaw near_contact_law(const CoupledScene& scene);

/// Beads deeper in each other than this part of the smaller one's radius are at fault.
constexpr double deepest_overlap = 0.2;

/// The fault, its step not set, if beads are deeper in each other than that.
std::optional<Fault> overlap_of(const BeadName& bead, const BeadName& other, const Vec3& position, double gap,
                                double smaller_radius);

struct CloseBeads {
  double smallest_gap = std::numeric_limits<double>::infinity();  ///< of those within the law's reach [cell]
  std::optional<Fault> overlap;                                   ///< the first, if any
};

/// Adds what close beads hand each other in the coming step to their impulses, but for beads of the same
/// swimmer as they are joined: these are its owner's (push_chain). Each pair of images belongs to the block
/// in which the middle of its gap lies.
CloseBeads push_close_beads(const NearContactLaw& law, const Coverage& coverage,
                            std::span<BeadOnLattice> beads);

/// The same among a swimmer's own beads, where they are at the start of a step: adds to `impulses` what
/// others hand them, and to swimmer.firmness.
void push_chain(const NearContactLaw& law, const SwimmerType& type, SwimmerState& swimmer,
                SwimmerLoads& impulses);

}  // namespace beadswim
