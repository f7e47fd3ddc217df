#pragma once

#include <optional>
#include <span>
#include <vector>

#include "beadswim/core/box.hpp"
#include "beadswim/core/vec3.hpp"

namespace beadswim {

/// Distance from each point to its nearest neighbour [length], in the order of the points. Neighbours are all
/// other points and, along periodic axes, the periodic images of all points, the point's own too: so a unit
/// cell has the distances of the lattice that it stands for. Infinite where there is no neighbour; NaN for
/// all points if one is not finite.
///   points  anywhere, any number of periods outside of the box too
///   box     of lengths > 0 along periodic axes; its other axes are not used; none: open space
std::vector<double> nearest_neighbour_distances(std::span<const Vec3> points, const std::optional<Box>& box);

}  // namespace beadswim
