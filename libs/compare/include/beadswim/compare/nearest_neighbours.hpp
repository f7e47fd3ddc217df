#pragma once

#include <optional>
#include <span>
#include <vector>

#include "beadswim/core/box.hpp"
#include "beadswim/core/vec3.hpp"

namespace beadswim {

/// Returns the distance from each point to its nearest neighbour [length], in the order of the points.
/// Neighbours are all other points and, along periodic axes, the periodic images of all points. The images of
/// the point itself are also neighbours, so that the unit cell of a crystal yields the distances in the
/// crystal. A distance is infinite if there is no neighbour. All distances are NaN if any point is
/// non-finite.
///   points  may be outside the box by any number of periods [length]
///   box     with positive lengths along periodic axes [length]; other axes are ignored; nullopt: open space
std::vector<double> nearest_neighbour_distances(std::span<const Vec3> points, const std::optional<Box>& box);

}  // namespace beadswim
