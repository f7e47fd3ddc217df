#include "beadswim/scene/reduce.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <unordered_map>

#include "beadswim/core/error.hpp"
#include "beadswim/core/setting.hpp"

namespace beadswim {
namespace {

/// Finds swimmers in a periodic box by their positions, in a hash table of small cells. The edge of a cell is
/// at least five times the tolerance and at least 2^-20 of the edge of the box, or all of it.
class SwimmerFinder {
 public:
  SwimmerFinder(const Layout& layout, double tolerance) : layout_(layout), tolerance_(tolerance) {
    constexpr double max_count = 1 << 20;
    counts_ = (box_->lengths / (5 * tolerance)).array().floor().max(1).min(max_count);
    swimmers_.reserve(layout.swimmers.size());
  }

  void add(std::size_t s) {
    for_each_cell_around(layout_.swimmers[s].position, 0,
                         [&](std::uint64_t cell) { swimmers_.emplace(cell, s); });
  }

  /// Returns the distance from `position` to the nearest added swimmer that is equivalent to swimmer `s` and
  /// within the tolerance [length]. Returns infinity if there is no such swimmer.
  double distance_to_twin(std::size_t s, const Vec3& position) const {
    double nearest = std::numeric_limits<double>::infinity();
    constexpr double reach = 0.25;  // at least the tolerance and roundoff [edge of a cell]
    for_each_cell_around(position, reach, [&](std::uint64_t cell) {
      const auto [begin, end] = swimmers_.equal_range(cell);
      for (auto found = begin; found != end; ++found) {
        const std::size_t other = found->second;
        const double distance = nearest_separation(position, layout_.swimmers[other].position, box_).norm();
        if (other != s && distance <= tolerance_ && distance < nearest && are_alike(s, other))
          nearest = distance;
      }
    });
    return nearest;
  }

 private:
  /// Calls visit(key) for each cell that is within `reach` cells of the position along each axis.
  template <class Visitor>
  void for_each_cell_around(const Vec3& position, double reach, const Visitor& visit) const {
    // Swarms are often regular: the shift by half a cell keeps their swimmers away from the faces of cells.
    const Eigen::Array3d place =
        (wrapped(position, box_).cwiseQuotient(box_->lengths).array() * counts_) + 0.5;
    const Eigen::Array3d low = (place - reach).floor(), high = (place + reach).floor();
    const auto wrap = [&](double index, int axis) {
      return static_cast<std::uint64_t>(index - counts_[axis] * std::floor(index / counts_[axis]));
    };
    for (double i = low[0]; i <= high[0]; ++i)
      for (double j = low[1]; j <= high[1]; ++j)
        for (double k = low[2]; k <= high[2]; ++k)
          visit(((wrap(i, 0) << 20 | wrap(j, 1)) << 20) | wrap(k, 2));
  }

  bool are_alike(std::size_t a, std::size_t b) const {
    constexpr double same_axis = 1e-9;
    const Swimmer &one = layout_.swimmers[a], &other = layout_.swimmers[b];
    if (one.type != other.type || (one.orientation() - other.orientation()).norm() > same_axis) return false;
    return layout_.driving_of(one) == layout_.driving_of(other);
  }

  const Layout& layout_;
  const std::optional<Box>& box_ = layout_.domain.box;
  double tolerance_;
  Eigen::Array3d counts_;                                           ///< number of cells along each axis
  std::unordered_multimap<std::uint64_t, std::size_t> swimmers_{};  ///< by the key of the cell
};

/// Displaces the scene along `axis` by the edge of the box divided by `parts`, and searches, for each
/// displaced swimmer, the nearest equivalent swimmer of the original scene. Returns the largest distance
/// between the two [length], or infinity if a swimmer has no equivalent one.
double largest_shift_after_move(const Layout& layout, const SwimmerFinder& finder, int axis,
                                std::size_t parts) {
  const Vec3 step = Vec3::Unit(axis) * layout.domain.box->lengths[axis] / static_cast<double>(parts);
  double largest = 0;
  for (std::size_t s = 0; s < layout.swimmers.size() && std::isfinite(largest); ++s)
    largest = std::max(largest, finder.distance_to_twin(s, layout.swimmers[s].position + step));
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
  SwimmerFinder finder(layout, tolerance);
  for (std::size_t s = 0; s < all; ++s) finder.add(s);
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
  SwimmerFinder kept(result.layout, 2 * tolerance);
  std::vector<Swimmer> firsts;
  for (std::size_t s = 0; s < all; ++s) {
    if (std::isfinite(kept.distance_to_twin(s, result.layout.swimmers[s].position))) continue;
    kept.add(s);
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
