#pragma once

#include <span>
#include <vector>

#include "beadswim/figure/swarm_picture.hpp"
#include "beadswim/scene/layers.hpp"

namespace beadswim {

/// The distances of the paper's figure 4, each drawn once at the swarm's outline: C from a swimmer to the
/// next of its block, D to that of the next block; across y and z between the beads furthest along x, along x
/// between the end beads that face each other. `layers` are those of the swimmers, `block_swimmers` the
/// swimmers of a block along each axis. Throws InputError where no swimmer has a neighbour along an axis, and
/// for blocks by id.
std::vector<PictureDistance> swarm_distances(std::span<const PicturedSwimmer> swimmers,
                                             std::span<const Layer> layers,
                                             std::span<const int> block_swimmers);

}  // namespace beadswim
