#pragma once

#include <array>
#include <span>
#include <vector>

#include "beadswim/core/vec3.hpp"

namespace beadswim {

/// Distance from each point to its nearest neighbour [length], in the order of the points. Neighbours are all
/// other points and, along periodic axes, the periodic images of all points, the point's own too: so a unit
/// cell has the distances of the lattice that it stands for. Infinite where there is no neighbour; NaN for
/// all points if one is not finite.
///   points       anywhere, any number of periods outside of the box too
///   box_lengths  > 0 along periodic axes; not used along others
std::vector<double> nearest_neighbour_distances(std::span<const Vec3> points, const Vec3& box_lengths,
                                                const std::array<bool, 3>& periodic);

}  // namespace beadswim
