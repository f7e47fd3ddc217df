#pragma once

#include "beadswim/coupling/scene.hpp"

namespace beadswim {

/// Returns a uniform swarm as in the paper (Pickl et al. 2017) in a periodic box of edge x edge x (edge x
/// ranks) cells. Bead radius: 6 cells; arms: 32 cells; distance of neighbouring rows: 32 cells. The box
/// contains as many swimmers as fit. A swimmer needs 96 cells along x. For a shorter edge, all lengths are
/// multiplied by edge/96, so that the beads occupy the same volume fraction.
CoupledScene swarm_scene(int edge, int ranks, Precision precision, BeadScheme bead_boundary);

}  // namespace beadswim
