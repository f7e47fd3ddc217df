#pragma once

#include "beadswim/core/communicator.hpp"
#include "scene_on_lattice.hpp"

namespace beadswim {

/// Bytes that the whole lattice takes: populations, and which bead covers a cell.
double lattice_bytes(const CoupledScene& scene);

/// Throws InputError on all ranks if a node's ranks need more memory than the node has. Collective.
void require_memory(const CoupledScene& scene, const Communicator& communicator);

}  // namespace beadswim
