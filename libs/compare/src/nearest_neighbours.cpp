#include "beadswim/compare/nearest_neighbours.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nanoflann.hpp>

// The neighbours are found in a k-d tree, which costs N log N whether points crowd or straggle (Friedman,
// Bentley and Finkel 1977); cells would need a width.

namespace beadswim {
namespace {

using Points = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;
using Tree = nanoflann::KDTreeEigenMatrixAdaptor<Points, 3, nanoflann::metric_L2_Simple>;

/// A result set of nanoflann: the least squared distance to a point other than `self`.
struct NearestOther {
  using DistanceType = double;
  using IndexType = Tree::IndexType;
  IndexType self;
  double squared_distance;

  bool full() const { return true; }
  double worstDist() const { return squared_distance * (1 + 1e-12); }  // bounds of branches are rounded
  bool addPoint(double squared, IndexType point) {
    if (point != self) squared_distance = std::min(squared_distance, squared);
    return squared_distance > 0;  // whether to go on: among points at one place, all are as near
  }
};

/// Moves a place into the box around the origin, along periodic axes. A remainder is exact: no bit is lost.
Vec3 folded(Vec3 place, const std::optional<Box>& box) {
  for (int axis = 0; axis < 3 && box; ++axis) {
    if (box->is_periodic(axis)) place[axis] = std::remainder(place[axis], box->lengths[axis]);
  }
  return place;
}

/// Shifts of a box to itself and to those around it, at most 27. Folded points are at most one period apart
/// along an axis, so that images further away are not the nearest.
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
  if (points.empty() || !std::ranges::all_of(points, [](const Vec3& p) { return p.allFinite(); }))
    return distances;

  Points places(points.size(), 3);
  for (std::size_t i = 0; i < points.size(); ++i) places.row(i) = folded(points[i], box);
  const Tree tree(3, places);
  const Eigen::AlignedBox3d extent(places.colwise().minCoeff(), places.colwise().maxCoeff());
  const std::vector<Vec3> shifts = shifts_to_images(box);
  const double own_image = shortest_period(box);
  for (Eigen::Index i = 0; i < places.rows(); ++i) {
    NearestOther nearest{i, own_image * own_image};
    for (const Vec3& shift : shifts) {
      const Vec3 image = places.row(i).transpose() + shift;
      if (extent.squaredExteriorDistance(image) < nearest.squared_distance)
        tree.index->findNeighbors(nearest, image.data(), nanoflann::SearchParams());
    }
    distances[i] = std::sqrt(nearest.squared_distance);
  }
  return distances;
}

}  // namespace beadswim
