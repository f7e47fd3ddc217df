#include "beadswim/scene/reduce.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "beadswim/core/error.hpp"
#include "beadswim/core/setting.hpp"
#include "cell_list.hpp"

namespace beadswim {
namespace {

/// Middle beads in a periodic box, to be found by place.
class Places {
 public:
  Places(const Layout& layout, const Box& box, std::size_t expected)
      : layout_(layout), box_(box), list_(box_, spacing(box, expected)) {}

  void insert(std::size_t s) { list_.insert(s, layout_.swimmers[s].position); }

  /// Another swimmer like `s`, but for its place, within `tolerance` of `position`: its distance; none:
  /// infinite.
  double distance_to_twin(std::size_t s, const Vec3& position, double tolerance) const {
    double least = std::numeric_limits<double>::infinity();
    list_.visit_near(position, [&](std::size_t other) {
      const double distance = nearest_separation(position, layout_.swimmers[other].position, box_).norm();
      if (other != s && distance <= tolerance && distance < least && alike(s, other)) least = distance;
      return true;
    });
    return least;
  }

 private:
  /// Edge of cells that hold about one swimmer each.
  static double spacing(const Box& box, std::size_t swimmers) {
    return std::cbrt(box.lengths.prod() / static_cast<double>(std::max<std::size_t>(swimmers, 1)));
  }

  bool alike(std::size_t a, std::size_t b) const {
    constexpr double same_axis = 1e-9;
    const Swimmer &one = layout_.swimmers[a], &other = layout_.swimmers[b];
    if (one.type != other.type || (one.axis - other.axis).norm() > same_axis) return false;
    if (!one.driving && !other.driving) return true;
    return layout_.resolved_type(one).driving == layout_.resolved_type(other).driving;
  }

  const Layout& layout_;
  std::optional<Box> box_;
  CellList list_;
};

/// The largest shift with which the scene maps onto itself when moved by a `parts`-th of its edge; infinite
/// if it does not.
double shift_of(const Layout& layout, const Places& places, int axis, std::size_t parts, double tolerance) {
  const Vec3 step = Vec3::Unit(axis) * layout.domain->lengths[axis] / static_cast<double>(parts);
  double largest = 0;
  for (std::size_t s = 0; s < layout.swimmers.size() && std::isfinite(largest); ++s)
    largest = std::max(largest, places.distance_to_twin(s, layout.swimmers[s].position + step, tolerance));
  return largest;
}

}  // namespace

ReducedCell reduce(const Layout& layout, double tolerance) {
  if (!layout.domain) {
    throw InputError(
        "/domain",
        fmt::format("is null (unbounded fluid), which does not repeat; make the layout with {} X,Y,Z",
                    Setting::box));
  }
  const std::size_t all = layout.swimmers.size();
  ReducedCell result{.layout = layout};
  Places places(layout, *layout.domain, all);
  for (std::size_t s = 0; s < all; ++s) places.insert(s);
  for (int axis = 0; axis < 3; ++axis) {
    if (!layout.domain->is_periodic(axis)) continue;
    for (std::size_t parts = all; parts > 1; --parts) {
      if (all % parts != 0) continue;
      const double shift = shift_of(layout, places, axis, parts, tolerance);
      if (!std::isfinite(shift)) continue;
      result.cells[axis] = static_cast<int>(parts);
      result.largest_shift = std::max(result.largest_shift, shift);
      break;
    }
  }

  Box& cell = *result.layout.domain;
  cell.lengths = layout.domain->lengths.cwiseQuotient(result.cells.cast<double>().matrix());
  for (Swimmer& swimmer : result.layout.swimmers) swimmer.position = wrapped(swimmer.position, cell);
  // One of each that have become the same; twins of twins are within twice the tolerance.
  Places kept(result.layout, cell, all);
  std::vector<Swimmer> firsts;
  for (std::size_t s = 0; s < all; ++s) {
    if (std::isfinite(kept.distance_to_twin(s, result.layout.swimmers[s].position, 2 * tolerance))) continue;
    kept.insert(s);
    firsts.push_back(result.layout.swimmers[s]);
  }
  if (static_cast<double>(firsts.size()) * result.cells.cast<double>().prod() != static_cast<double>(all)) {
    throw InputError(Setting::tolerance,
                     "is so large that swimmers are taken for one another; take a smaller one");
  }
  result.layout.swimmers = std::move(firsts);
  return result;
}

}  // namespace beadswim
