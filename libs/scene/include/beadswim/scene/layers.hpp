#pragma once

#include <array>
#include <span>
#include <vector>

#include "beadswim/scene/layout.hpp"

namespace beadswim {

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
