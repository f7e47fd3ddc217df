#pragma once

#include <array>
#include <span>
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

/// Numbers of the layers along x, y and z in which a swimmer lies, starting at 0.
using Layer = std::array<int, 3>;

/// Returns the layer of each swimmer's position, in the order of the layout. Along each axis, the
/// coordinates of the positions are sorted. Successive coordinates that differ by at most the smallest
/// bead radius belong to the same layer.
std::vector<Layer> swimmer_layers(const Layout& layout);

/// Returns the number of layers along each axis.
Layer layer_count(std::span<const Layer> layers);

/// Returns the number of the block that a swimmer belongs to. The number selects the colour of the swimmer.
/// `block_swimmers` contains three numbers or one number. Three numbers are the swimmers per block along x,
/// y, z; the block numbers are then 0 and 1 in a checkerboard pattern. If there is one number N, the block
/// number is id / N, rounded down.
int block_number(int id, const Layer& layer, std::span<const int> block_swimmers);

}  // namespace beadswim
