#pragma once

#include <string>
#include <vector>

#include "beadswim/core/vec3.hpp"
#include "beadswim/scene/layout.hpp"

namespace beadswim {

/// Swimmers parallel to x in equal blocks, as in the paper's figure 4. C and D are distances between bead
/// centres. Along y and z they are measured from one swimmer to the next, along x between the facing end
/// beads.
struct SwarmPlan {
  Index3 block_swimmers{1, 3, 3};  ///< swimmers per block along x, y, z
  Index3 blocks{1, 1, 1};          ///< blocks along x, y, z
  Vec3 core_gap = Vec3::Zero();    ///< C: distance of neighbours in the same block [length]
  Vec3 block_gap = Vec3::Zero();   ///< D: distance of neighbours in different blocks [length]
};

/// Returns the edges of one block [length], including D to the next block.
Vec3 block_lengths(const SwarmPlan& plan, const SwimmerType& type);

/// Returns the periodic box that contains all blocks.
Box swarm_box(const SwarmPlan& plan, const SwimmerType& type);

/// Returns the swimmers of all blocks. Across the faces of the periodic box, neighbours have the distance D.
/// Ids increase from block to block with x fastest, and in the same order within each block. The number of a
/// block is id / (swimmers per block).
std::vector<Swimmer> swarm_swimmers(const SwarmPlan& plan, const SwimmerType& type,
                                    const std::string& type_name);

}  // namespace beadswim
