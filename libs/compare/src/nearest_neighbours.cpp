#include "beadswim/compare/nearest_neighbours.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

// A k-d tree, which unlike cells has no width to choose and minds neither crowds nor stragglers: N log N
// whatever the points (Friedman, Bentley and Finkel 1977).

namespace beadswim {
namespace {

/// A point, and the axis across which it parts its range of nodes into a lower and an upper half. A range is
/// a tree, the node in its middle the root.
struct Node {
  Vec3 place;
  std::size_t point = 0;
  int axis = 0;
};

Eigen::AlignedBox3d extent_of(std::span<const Node> nodes) {
  Eigen::AlignedBox3d extent;
  for (const Node& node : nodes) extent.extend(node.place);
  return extent;
}

void make_tree(std::span<Node> nodes) {
  if (nodes.size() < 2) return;
  int axis = 0;
  extent_of(nodes).sizes().maxCoeff(&axis);
  const std::size_t middle = nodes.size() / 2;
  std::nth_element(nodes.begin(), nodes.begin() + static_cast<std::ptrdiff_t>(middle), nodes.end(),
                   [axis](const Node& a, const Node& b) { return a.place[axis] < b.place[axis]; });
  nodes[middle].axis = axis;
  make_tree(nodes.first(middle));
  make_tree(nodes.subspan(middle + 1));
}

/// The least of `nearest` and the squared distances from a place to the nodes of a tree other than `self`.
double nearest_squared(std::span<const Node> tree, const Node& self, const Vec3& place, double nearest) {
  if (tree.empty()) return nearest;
  const std::size_t middle = tree.size() / 2;
  const Node& root = tree[middle];
  const auto lower = tree.first(middle), upper = tree.subspan(middle + 1);
  if (&root != &self) nearest = std::min(nearest, (place - root.place).squaredNorm());
  const double above = place[root.axis] - root.place[root.axis];
  nearest = nearest_squared(above < 0 ? lower : upper, self, place, nearest);
  if (above * above < nearest) nearest = nearest_squared(above < 0 ? upper : lower, self, place, nearest);
  return nearest;
}

/// Into the box around the origin, along periodic axes. A remainder is exact: nothing is lost on the way.
Vec3 folded(Vec3 place, const std::optional<Box>& box) {
  for (int axis = 0; axis < 3 && box; ++axis) {
    if (box->is_periodic(axis)) place[axis] = std::remainder(place[axis], box->lengths[axis]);
  }
  return place;
}

/// From a box to those around it, at most 26. Folded points are at most one period apart along an axis, so
/// that images further away are not the nearest.
std::vector<Vec3> shifts_to_images(const std::optional<Box>& box) {
  std::vector<Vec3> shifts{Vec3::Zero()};
  for (int axis = 0; axis < 3 && box; ++axis) {
    if (!box->is_periodic(axis)) continue;
    const std::size_t count = shifts.size();
    for (const double sign : {-1.0, 1.0}) {
      for (std::size_t i = 0; i < count; ++i) {
        shifts.push_back(shifts[i] + sign * box->lengths[axis] * Vec3::Unit(axis));
      }
    }
  }
  shifts.erase(shifts.begin());
  return shifts;
}

/// Distance from a point to its own nearest image.
double shortest_period(const std::optional<Box>& box) {
  double shortest = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3 && box; ++axis) {
    if (box->is_periodic(axis)) shortest = std::min(shortest, box->lengths[axis]);
  }
  return shortest;
}

}  // namespace

std::vector<double> nearest_neighbour_distances(std::span<const Vec3> points, const std::optional<Box>& box) {
  std::vector<double> distances(points.size(), std::numeric_limits<double>::quiet_NaN());
  if (!std::all_of(points.begin(), points.end(), [](const Vec3& p) { return p.allFinite(); }))
    return distances;

  std::vector<Node> tree;
  tree.reserve(points.size());
  for (const Vec3& point : points) tree.push_back({folded(point, box), tree.size()});
  make_tree(tree);

  const Eigen::AlignedBox3d extent = extent_of(tree);
  const std::vector<Vec3> shifts = shifts_to_images(box);
  const double own_image = shortest_period(box);
  for (const Node& node : tree) {
    double nearest = nearest_squared(tree, node, node.place, own_image * own_image);
    for (const Vec3& shift : shifts) {
      const Vec3 image = node.place + shift;
      if (extent.squaredExteriorDistance(image) >= nearest) continue;
      nearest = nearest_squared(tree, node, image, nearest);
    }
    distances[node.point] = std::sqrt(nearest);
  }
  return distances;
}

}  // namespace beadswim
