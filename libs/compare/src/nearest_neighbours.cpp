#include "beadswim/compare/nearest_neighbours.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nanoflann.hpp>

// A k-d tree finds the neighbours (Friedman, Bentley and Finkel 1977). Its cost is O(N log N) for any
// distribution of the points. A cell list would need a cell size that suits the distribution.

namespace beadswim {
namespace {

using Points = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;
using Tree = nanoflann::KDTreeEigenMatrixAdaptor<Points, 3, nanoflann::metric_L2_Simple>;

/// Result set for nanoflann that finds the smallest squared distance to a point other than `self`.
struct NearestOther {
  using DistanceType = double;
  using IndexType = Tree::IndexType;
  IndexType self;
  double squared_distance;

  bool full() const { return true; }
  double worstDist() const { return squared_distance * (1 + 1e-12); }  // margin for roundoff in the search
  bool addPoint(double squared, IndexType point) {
    if (point != self) squared_distance = std::min(squared_distance, squared);
    return squared_distance > 0;  // false ends the search: no point can be closer than distance 0
  }
};

/// Wraps the periodic coordinates of a point into the box centred at the origin. std::remainder is exact.
Vec3 wrap_point(Vec3 place, const std::optional<Box>& box) {
  for (int axis = 0; axis < 3 && box; ++axis) {
    if (box->is_periodic(axis)) place[axis] = std::remainder(place[axis], box->lengths[axis]);
  }
  return place;
}

/// Returns the displacements from a box to itself and to its adjacent periodic images, at most 27. Along each
/// axis, the coordinates of two wrapped points differ by at most one period. Images that are further away are
/// therefore never the nearest.
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

/// Returns the distance from a point to its own nearest periodic image [length]; infinity in open space or
/// between walls.
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
  for (std::size_t i = 0; i < points.size(); ++i) places.row(i) = wrap_point(points[i], box);
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
