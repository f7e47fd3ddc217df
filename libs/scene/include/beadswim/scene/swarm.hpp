#pragma once

#include <string>
#include <vector>

#include "beadswim/core/vec3.hpp"
#include "beadswim/scene/layout.hpp"

namespace beadswim {

/// Swimmers parallel to x in equal blocks, as in figure 4 of the paper (Pickl et al. 2017). C and D are
/// distances between bead centres of neighbouring swimmers. Along y and z, corresponding beads are compared.
/// Along x, the distance is between the end beads that face each other.
struct SwarmPlan {
  Index3 block_swimmers{1, 3, 3};  ///< swimmers per block along x, y, z
  Index3 blocks{1, 1, 1};          ///< blocks along x, y, z
  Vec3 core_gap = Vec3::Zero();    ///< C: distance of neighbours in the same block [length]
  Vec3 block_gap = Vec3::Zero();   ///< D: distance of neighbours in different blocks [length]
};

/// Returns the edges of one block [length], including the distance D to the next block.
Vec3 block_lengths(const SwarmPlan& plan, const SwimmerType& type);

/// Returns the periodic box that contains all blocks.
Box swarm_box(const SwarmPlan& plan, const SwimmerType& type);

/// Returns the swimmers of all blocks. Neighbours on both sides of a periodic face have the distance D
/// (SwarmPlan). Ids start at 0. They count the swimmers of the first block, then of the next block, and so
/// on. x varies fastest, then y, then z, both within a block and from block to block. The number of a block
/// is therefore id / (swimmers per block), rounded down.
std::vector<Swimmer> swarm_swimmers(const SwarmPlan& plan, const SwimmerType& type,
                                    const std::string& type_name);

}  // namespace beadswim
