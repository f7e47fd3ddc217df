#pragma once

#include <string>
#include <vector>

#include "beadswim/core/vec3.hpp"
#include "beadswim/scene/layout.hpp"

namespace beadswim {

/// Swimmers along x in equal blocks, as in the paper's figure 4. Gaps are between centres: across x from one
/// swimmer to the next, along x between the end beads that face each other.
struct SwarmPlan {
  Index3 block_swimmers{1, 3, 3};  ///< swimmers of a block along x, y, z
  Index3 blocks{1, 1, 1};          ///< along x, y, z
  Vec3 core_gap = Vec3::Zero();    ///< C between neighbours in one block [length]
  Vec3 block_gap = Vec3::Zero();   ///< D between neighbours of two blocks [length]
};

/// Edges of one block, of which the swarm's periodic box is a whole number.
Vec3 block_lengths(const SwarmPlan& plan, const SwimmerType& type);

/// The periodic box of all blocks.
Box swarm_box(const SwarmPlan& plan, const SwimmerType& type);

/// The swarm in its box; the outer gaps are those between blocks, so that periodic images carry
/// it on. Ids count up block by block, x fastest, and within each block likewise: id / (swimmers of a block)
/// is the number of the block.
std::vector<Swimmer> swarm_swimmers(const SwarmPlan& plan, const SwimmerType& type,
                                    const std::string& type_name);

}  // namespace beadswim
