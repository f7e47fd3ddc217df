#pragma once

#include "beadswim/core/communicator.hpp"
#include "beadswim/coupling/scene.hpp"

namespace beadswim {

/// Returns the surface area of all beads [cell^2].
double bead_surface(const CoupledScene& scene);

/// Returns the memory of the complete lattice, summed over all ranks [byte]: populations, coverage and links.
double lattice_bytes(const CoupledScene& scene);

/// Returns the memory of this machine [byte].
double installed_bytes();

/// Throws InputError on all ranks if the ranks of a machine need more memory than this machine has.
/// Collective.
void require_memory(const CoupledScene& scene, const Communicator& communicator);

}  // namespace beadswim
