#include "beadswim/scene/reduce.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "beadswim/core/cell_list.hpp"
#include "beadswim/core/error.hpp"
#include "beadswim/core/setting.hpp"

namespace beadswim {
namespace {

std::vector<Vec3> positions_of(const Layout& layout) {
  std::vector<Vec3> positions;
  for (const Swimmer& swimmer : layout.swimmers) positions.push_back(swimmer.position);
  return positions;
}

/// Returns true if the beads of two swimmers have the same places at the start, relative to the swimmers.
bool start_alike(const Swimmer& one, const Swimmer& other, double tolerance) {
  if (!one.start || !other.start) return one.start.has_value() == other.start.has_value();
  return std::ranges::equal(one.start->positions, other.start->positions, [&](const Vec3& a, const Vec3& b) {
    return ((a - one.position) - (b - other.position)).norm() <= tolerance;
  });
}

bool are_alike(const Layout& layout, const Swimmer& one, const Swimmer& other, double tolerance) {
  constexpr double same_axis = 1e-9;
  return one.type == other.type && (one.orientation() - other.orientation()).norm() <= same_axis &&
         layout.driving_of(one) == layout.driving_of(other) && start_alike(one, other, tolerance);
}

/// Finds equivalent swimmers in a periodic box by their positions.
struct TwinFinder {
  const Layout& layout;
  double tolerance;  ///< [length]
  CellList cells{positions_of(layout), 5 * tolerance, layout.domain.box->lengths};

  /// Returns the distance from `position` to swimmer `other` [length]; infinity if this swimmer is swimmer
  /// `s`, not equivalent to it, or not within the tolerance.
  double distance_to_twin(std::size_t s, const Vec3& position, std::size_t other) const {
    const Swimmer& twin = layout.swimmers[other];
    const double distance = nearest_separation(position, twin.position, layout.domain.box).norm();
    const bool is_twin =
        other != s && distance <= tolerance && are_alike(layout, layout.swimmers[s], twin, tolerance);
    return is_twin ? distance : std::numeric_limits<double>::infinity();
  }
};

/// Displaces the scene along `axis` by the edge of the box divided by `parts`, and searches, for each
/// displaced swimmer, the nearest equivalent swimmer of the original scene. Returns the largest distance
/// between the two [length], or infinity if a swimmer has no equivalent one.
double largest_shift_after_move(const TwinFinder& finder, int axis, std::size_t parts) {
  const Layout& layout = finder.layout;
  const Vec3 step = Vec3::Unit(axis) * layout.domain.box->lengths[axis] / static_cast<double>(parts);
  double largest = 0;
  for (std::size_t s = 0; s < layout.swimmers.size() && std::isfinite(largest); ++s) {
    const Vec3 position = layout.swimmers[s].position + step;
    double nearest = std::numeric_limits<double>::infinity();
    finder.cells.visit_neighbours(position, [&](std::size_t other) {
      nearest = std::min(nearest, finder.distance_to_twin(s, position, other));
      return true;
    });
    largest = std::max(largest, nearest);
  }
  return largest;
}

}  // namespace

ReducedCell reduce(const Layout& layout, double tolerance) {
  if (!layout.domain.box) {
    throw InputError(
        "/domain", "the fluid is unbounded ({}), so the scene does not repeat; make the layout with {} X,Y,Z",
        in_words(layout.domain), Setting::box);
  }
  const std::size_t all = layout.swimmers.size();
  ReducedCell result{.layout = layout};
  const TwinFinder finder{.layout = layout, .tolerance = tolerance};
  for (int axis = 0; axis < 3; ++axis) {
    if (!layout.domain.box->is_periodic(axis)) continue;
    for (std::size_t parts = all; parts > 1; --parts) {
      if (all % parts != 0) continue;
      const double shift = largest_shift_after_move(finder, axis, parts);
      if (!std::isfinite(shift)) continue;
      result.cells[axis] = static_cast<int>(parts);
      result.largest_shift = std::max(result.largest_shift, shift);
      break;
    }
  }

  Box& cell = *result.layout.domain.box;
  cell.lengths = layout.domain.box->lengths.cwiseQuotient(result.cells.cast<double>().matrix());
  for (Swimmer& swimmer : result.layout.swimmers) swimmer.move_to(wrapped(swimmer.position, cell));
  // Keeps one swimmer of each set of equivalent swimmers. Two swimmers within the tolerance of a third
  // swimmer can differ by up to twice the tolerance.
  const TwinFinder in_cell{.layout = result.layout, .tolerance = 2 * tolerance};
  std::vector<bool> is_kept(all);
  std::vector<Swimmer> firsts;
  for (std::size_t s = 0; s < all; ++s) {
    const Swimmer& swimmer = result.layout.swimmers[s];
    // Ends at the first twin, because many swimmers can lie at one place.
    is_kept[s] = in_cell.cells.visit_neighbours(swimmer.position, [&](std::size_t other) {
      return !is_kept[other] || !std::isfinite(in_cell.distance_to_twin(s, swimmer.position, other));
    });
    if (is_kept[s]) firsts.push_back(swimmer);
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
