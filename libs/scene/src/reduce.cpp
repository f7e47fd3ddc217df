#include "beadswim/scene/reduce.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "beadswim/core/cell_list.hpp"
#include "beadswim/core/error.hpp"
#include "beadswim/core/setting.hpp"

namespace beadswim {
namespace {

/// Finds swimmers in a periodic box by their positions.
class SwimmerFinder {
 public:
  SwimmerFinder(const Layout& layout, const Box& box, double tolerance)
      : layout_(layout),
        box_(box),
        tolerance_(tolerance),
        cells_(positions(layout), tolerance, box.lengths) {}

  /// Returns the distance from `position` to the nearest swimmer that is equivalent to swimmer `s`, is within
  /// the tolerance and for which admits(index) is true [length]. Returns infinity if there is no such
  /// swimmer.
  double distance_to_twin(std::size_t s, const Vec3& position,
                          const std::function<bool(std::size_t)>& admits) const {
    double nearest = std::numeric_limits<double>::infinity();
    cells_.visit_neighbours(position, [&](std::size_t other) {
      const double distance = nearest_separation(position, layout_.swimmers[other].position, box_).norm();
      if (other != s && distance <= tolerance_ && distance < nearest && admits(other) && are_alike(s, other))
        nearest = distance;
      return true;
    });
    return nearest;
  }

 private:
  static std::vector<Vec3> positions(const Layout& layout) {
    std::vector<Vec3> positions;
    for (const Swimmer& swimmer : layout.swimmers) positions.push_back(swimmer.position);
    return positions;
  }

  bool are_alike(std::size_t a, std::size_t b) const {
    constexpr double same_axis = 1e-9;
    const Swimmer &one = layout_.swimmers[a], &other = layout_.swimmers[b];
    if (one.type != other.type || (one.orientation() - other.orientation()).norm() > same_axis) return false;
    if (!one.driving && !other.driving) return true;
    return layout_.resolved_type(one).driving == layout_.resolved_type(other).driving;
  }

  const Layout& layout_;
  std::optional<Box> box_;
  double tolerance_;
  CellList cells_;
};

/// Displaces the scene along `axis` by the edge of the box divided by `parts`, and searches, for each
/// displaced swimmer, the nearest equivalent swimmer of the original scene. Returns the largest distance
/// between the two [length], or infinity if a swimmer has no equivalent one.
double largest_shift_after_move(const Layout& layout, const SwimmerFinder& finder, int axis,
                                std::size_t parts) {
  const Vec3 step = Vec3::Unit(axis) * layout.domain.box->lengths[axis] / static_cast<double>(parts);
  const auto is_any = [](std::size_t) { return true; };
  double largest = 0;
  for (std::size_t s = 0; s < layout.swimmers.size() && std::isfinite(largest); ++s)
    largest = std::max(largest, finder.distance_to_twin(s, layout.swimmers[s].position + step, is_any));
  return largest;
}

}  // namespace

ReducedCell reduce(const Layout& layout, double tolerance) {
  if (!layout.domain.box) {
    throw InputError("/domain", fmt::format("the fluid is unbounded ({}), so the scene does not repeat; make "
                                            "the layout with {} X,Y,Z",
                                            in_words(layout.domain), Setting::box));
  }
  const std::size_t all = layout.swimmers.size();
  ReducedCell result{.layout = layout};
  const SwimmerFinder finder(layout, *layout.domain.box, tolerance);
  for (int axis = 0; axis < 3; ++axis) {
    if (!layout.domain.box->is_periodic(axis)) continue;
    for (std::size_t parts = all; parts > 1; --parts) {
      if (all % parts != 0) continue;
      const double shift = largest_shift_after_move(layout, finder, axis, parts);
      if (!std::isfinite(shift)) continue;
      result.cells[axis] = static_cast<int>(parts);
      result.largest_shift = std::max(result.largest_shift, shift);
      break;
    }
  }

  Box& cell = *result.layout.domain.box;
  cell.lengths = layout.domain.box->lengths.cwiseQuotient(result.cells.cast<double>().matrix());
  for (Swimmer& swimmer : result.layout.swimmers) swimmer.position = wrapped(swimmer.position, cell);
  // Keeps one swimmer of each set of equivalent swimmers. Two swimmers within the tolerance of a third
  // swimmer can differ by up to twice the tolerance.
  const SwimmerFinder twins(result.layout, cell, 2 * tolerance);
  std::vector<bool> is_kept(all);
  std::vector<Swimmer> firsts;
  for (std::size_t s = 0; s < all; ++s) {
    const Vec3& position = result.layout.swimmers[s].position;
    if (std::isfinite(twins.distance_to_twin(s, position, [&](std::size_t other) { return is_kept[other]; })))
      continue;
    is_kept[s] = true;
    firsts.push_back(result.layout.swimmers[s]);
  }
  if (static_cast<double>(firsts.size()) * result.cells.cast<double>().prod() != static_cast<double>(all)) {
    throw InputError(Setting::tolerance,
                     "the tolerance of positions is so large that different swimmers count as periodic "
                     "copies of one swimmer; reduce the tolerance");
  }
  result.layout.swimmers = std::move(firsts);
  return result;
}

}  // namespace beadswim
