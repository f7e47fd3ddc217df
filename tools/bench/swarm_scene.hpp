#pragma once

#include "beadswim/coupling/scene.hpp"

namespace beadswim {

/// The paper's uniform swarm (beads of radius 6, arms of 32, rows 32 apart) as far as it fits into a periodic
/// box of edge x edge x (edge x ranks) cells; in boxes narrower than a swimmer's 96 cells all lengths are
/// scaled down, so that beads fill the same share of the box.
CoupledScene swarm_scene(int edge, int ranks, Precision precision, BeadScheme bead_boundary);

}  // namespace beadswim
