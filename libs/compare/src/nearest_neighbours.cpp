#include "beadswim/compare/nearest_neighbours.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

// The points are sorted along one axis. The search for the neighbours of a point goes from its place in both
// directions until the distance along this axis exceeds the smallest distance found. The cost is O(N^(5/3))
// for points that fill a volume. Unlike that of cells, it does not depend on the extent of the points: one of
// them may be far away from the others.

namespace beadswim {
namespace {

/// Periods along the three axes [length]; infinity: not periodic.
Vec3 periods_of(const std::optional<Box>& box) {
  Vec3 periods = Vec3::Constant(std::numeric_limits<double>::infinity());
  for (int axis = 0; axis < 3 && box; ++axis)
    if (box->is_periodic(axis)) periods[axis] = box->lengths[axis];
  return periods;
}

/// Returns the squared distance of two points that are in a box centred at the origin, or of their nearest
/// periodic images. Along each axis, the coordinates of the points differ by at most one period, so that only
/// adjacent images can be the nearest.
double squared_distance(const Vec3& a, const Vec3& b, const Vec3& periods) {
  double sum = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double along = std::min({std::abs(a[axis] - b[axis]), std::abs(a[axis] + periods[axis] - b[axis]),
                                   std::abs(a[axis] - periods[axis] - b[axis])});
    sum += along * along;
  }
  return sum;
}

/// Returns the smallest squared distance between the point `start` and the other points, or `limit` if none
/// is closer. `places`: in a box centred at the origin, sorted along `axis`; `step`: 1 searches upwards, -1
/// downwards along the axis.
double smallest_squared_distance(const std::vector<Vec3>& places, const Vec3& periods, int axis,
                                 std::ptrdiff_t start, int step, double limit) {
  const std::ptrdiff_t count = std::ssize(places);
  double shift = 0;  // of the periodic image that is searched
  for (std::ptrdiff_t t = start + step, visited = 1; visited < count && limit > 0; ++visited, t += step) {
    if (t < 0 || t == count) {
      t -= step * count;
      shift += step * periods[axis];
    }
    const double along = places[start][axis] - shift - places[t][axis];  // rounded as in squared_distance()
    if (along * along >= limit) break;
    limit = std::min(limit, squared_distance(places[start], places[t], periods));
  }
  return limit;
}

}  // namespace

std::vector<double> nearest_neighbour_distances(std::span<const Vec3> points, const std::optional<Box>& box) {
  std::vector<double> distances(points.size(), std::numeric_limits<double>::quiet_NaN());
  if (points.empty() || !std::ranges::all_of(points, [](const Vec3& p) { return p.allFinite(); }))
    return distances;

  const Vec3 periods = periods_of(box);
  Eigen::AlignedBox3d extent;
  const auto wrap = [&](int axis, std::size_t i) { return std::remainder(points[i][axis], periods[axis]); };
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (const std::size_t i : order) extent.extend(Vec3(wrap(0, i), wrap(1, i), wrap(2, i)));
  int axis = 0;
  extent.sizes().maxCoeff(&axis);
  std::ranges::sort(order, {}, [&](std::size_t i) { return wrap(axis, i); });
  std::vector<Vec3> places;
  for (const std::size_t i : order) places.emplace_back(wrap(0, i), wrap(1, i), wrap(2, i));
  for (std::ptrdiff_t s = 0; s < std::ssize(order); ++s) {
    double nearest = periods.minCoeff() * periods.minCoeff();  // to the point's own image
    for (const int step : {1, -1})
      nearest = smallest_squared_distance(places, periods, axis, s, step, nearest);
    distances[order[s]] = std::sqrt(nearest);
  }
  return distances;
}

}  // namespace beadswim
