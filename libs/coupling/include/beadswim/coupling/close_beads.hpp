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

// Loop over pairs of close beads, including periodic images, on the block of one rank. The law of one pair is
// in swimmers/near_contact.hpp.

namespace beadswim {

/// Returns the cutoffs below which the lattice lacks resistance of the film between two beads [cell]. Below
/// some gap the resistance of the lattice is constant; the cutoff is the gap at which this constant equals
/// the exact resistance (docs/verification.md). The smallest gap, which models roughness, is a thousandth of
/// smallest_radius.
LubricationRange lubrication_range(BeadScheme scheme, double smallest_radius);

/// Returns the near-contact law of the scene, in lattice units.
NearContactLaw near_contact_law(const CoupledScene& scene);

/// Largest permitted overlap of two beads [radius of the smaller bead].
constexpr double max_overlap = 0.2;

/// Returns a fault if the overlap -gap exceeds max_overlap. The step of the fault is not set.
std::optional<Fault> overlap_of(const BeadName& bead, const BeadName& other, const Vec3& position, double gap,
                                double smaller_radius);

/// Result of add_contact_impulses().
struct CloseBeads {
  double smallest_gap = std::numeric_limits<double>::infinity();  ///< of pairs within the cutoff [cell]
  std::optional<Fault> overlap;  ///< the first overlap that exceeds max_overlap
};

/// Adds the impulses of close pairs in the next step to the beads. Skips pairs within one swimmer, unless one
/// bead is a periodic image: the owner of the swimmer evaluates them (add_swimmer_contact_impulses). Each
/// pair is evaluated in the block that contains the middle of its gap.
CloseBeads add_contact_impulses(const NearContactLaw& law, const Coverage& coverage,
                                std::span<BeadOnLattice> beads);

/// Adds to `impulses` the impulses of close pairs within one swimmer, at the positions of the start of the
/// step. Before the call, `impulses` must contain the impulses from the beads of other swimmers. Also adds to
/// swimmer.removed_fraction.
void add_swimmer_contact_impulses(const NearContactLaw& law, const SwimmerType& type, SwimmerState& swimmer,
                                  SwimmerLoads& impulses);

}  // namespace beadswim
