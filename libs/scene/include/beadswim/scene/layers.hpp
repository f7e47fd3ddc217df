#pragma once

#include <array>
#include <span>
#include <vector>

#include "beadswim/scene/layout.hpp"

namespace beadswim {

/// Indices of a layer along x, y and z, from 0.
using Layer = std::array<int, 3>;

/// Returns the layer of each swimmer's middle bead, in the order of the layout. Along each axis the
/// coordinates are sorted; successive coordinates that differ by at most the smallest radius belong to the
/// same layer.
std::vector<Layer> swimmer_layers(const Layout& layout);

/// Returns the number of layers along each axis.
Layer layer_count(std::span<const Layer> layers);

/// Returns the number of the block that a swimmer belongs to, used to colour it. `block_swimmers` holds three
/// numbers or one. Three numbers are the swimmers per block along x, y, z; block numbers are then 0 and 1 in
/// a checkerboard pattern. One number N gives block id / N.
int block_number(int id, const Layer& layer, std::span<const int> block_swimmers);

}  // namespace beadswim
