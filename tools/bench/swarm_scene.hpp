#pragma once

#include "beadswim/coupling/scene.hpp"

namespace beadswim {

/// Returns a uniform swarm as in the paper (Pickl et al. 2017) in a periodic box of edge x edge x (edge x
/// ranks) cells: bead radius 6 cells, arms of 32 cells, rows at distances of 32 cells, and as many swimmers
/// as the box can contain. A swimmer needs 96 cells along x. If the edge is shorter, all lengths are scaled
/// by edge/96, so that the beads occupy the same volume fraction.
CoupledScene swarm_scene(int edge, int ranks, Precision precision, BeadScheme bead_boundary);

}  // namespace beadswim
