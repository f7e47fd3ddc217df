#pragma once

#include <array>
#include <span>
#include <vector>

#include "beadswim/scene/layout.hpp"

namespace beadswim {

/// Which layer along x, y and z, from 0.
using Layer = std::array<int, 3>;

/// The layers in which the swimmers' middle beads stand, in the layout's order. Along an axis, coordinates
/// less than a smallest radius from one another are of one layer.
std::vector<Layer> swimmer_layers(const Layout& layout);

/// How many layers there are along each axis.
Layer layer_count(std::span<const Layer> layers);

/// The block that a swimmer is of, as colours show it. `block_swimmers` are the swimmers of a block along
/// each axis: blocks are then 0 and 1 in a checkerboard. Or it is one number N: block id / N.
int block_number(int id, const Layer& layer, std::span<const int> block_swimmers);

}  // namespace beadswim
