#pragma once

#include "beadswim/core/communicator.hpp"
#include "scene_on_lattice.hpp"

namespace beadswim {

/// Bytes of the populations of the whole lattice.
double population_bytes(const CoupledScene& scene);

/// Throws InputError on all ranks if a node's ranks need more memory than the node has. Collective.
void require_memory(const CoupledScene& scene, const Communicator& communicator);

}  // namespace beadswim
