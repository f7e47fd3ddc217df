#pragma once

#include "beadswim/core/communicator.hpp"
#include "beadswim/coupling/scene.hpp"

namespace beadswim {

/// Of all beads [cell^2].
double bead_surface(const CoupledScene& scene);

/// Bytes that the whole lattice takes: populations, which cells are covered, and links at beads.
double lattice_bytes(const CoupledScene& scene);

/// Of this machine [byte].
double installed_bytes();

/// Throws InputError on all ranks if a node's ranks need more memory than the node has. Collective.
void require_memory(const CoupledScene& scene, const Communicator& communicator);

}  // namespace beadswim
