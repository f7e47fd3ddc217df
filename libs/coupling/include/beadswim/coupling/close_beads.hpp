#pragma once

#include <limits>
#include <optional>
#include <span>

#include "beadswim/coupling/bead_on_lattice.hpp"
#include "beadswim/coupling/coverage.hpp"
#include "beadswim/coupling/fault.hpp"
#include "beadswim/coupling/scene.hpp"
#include "beadswim/coupling/swimmer_state.hpp"
#include "beadswim/swimmers/near_contact.hpp"

// Loop over pairs of close beads, including periodic images, on the block of one rank. The equations for one
// pair are in swimmers/near_contact.hpp.

namespace beadswim {

/// Returns the range of gaps [cell] in which the resistance of the lubrication film between two beads must be
/// added. The lattice resolves the film only at gaps above a cutoff. At smaller gaps, the resistance on the
/// lattice stays constant, and the cutoff is the gap at which this constant equals the exact resistance
/// (docs/verification.md). The lower end of the range models the roughness of the surfaces. It is a
/// thousandth of `smallest_radius`, the radius of the smallest bead [cell].
LubricationRange lubrication_range(BeadScheme scheme, double smallest_radius);

/// Returns the near-contact law of the scene, in lattice units.
NearContactLaw near_contact_law(const CoupledScene& scene);

/// Largest permitted overlap of two beads, divided by the radius of the smaller bead.
constexpr double max_overlap = 0.2;

/// Result of add_contact_impulses().
struct CloseBeads {
  /// Smallest gap of all pairs whose gap is below NearContactLaw::cutoff() [cell]. Infinite if there is no
  /// such pair.
  double smallest_gap = std::numeric_limits<double>::infinity();
  std::optional<Fault> overlap;  ///< the first overlap that exceeds max_overlap
};

/// Adds to BeadOnLattice::impulse the impulses that close pairs of beads exchange in the next step, and finds
/// gaps and overlaps. Adds no impulses to a pair of beads of the same swimmer, because the owner of the
/// swimmer evaluates them (add_swimmer_contact_impulses()), except to a pair of a bead and a periodic image.
/// Each pair is evaluated on the rank whose block contains the middle of the gap.
CloseBeads add_contact_impulses(const NearContactLaw& law, const Coverage& coverage,
                                std::span<BeadOnLattice> beads);

/// Adds to `impulses` the impulses of close pairs within one swimmer, evaluated at the positions at the start
/// of the step. Before the call, `impulses` must contain the impulses from the beads of other swimmers. Also
/// adds the contributions of these pairs to swimmer.removed_fraction.
void add_swimmer_contact_impulses(const NearContactLaw& law, const SwimmerType& type, SwimmerState& swimmer,
                                  SwimmerLoads& impulses);

}  // namespace beadswim
