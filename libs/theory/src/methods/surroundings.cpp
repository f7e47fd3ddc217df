#include "beadswim/theory/question.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "beadswim/core/setting.hpp"

namespace beadswim {
namespace {

/// Returns 0, 1 or 2 for an axis parallel to x, y or z, in either direction; nullopt otherwise.
std::optional<int> coordinate_axis(const Vec3& axis) {
  constexpr double largest_sine = 1e-9;  // roundoff of a normalised axis
  for (int i = 0; i < 3; ++i) {
    if (axis.cross(Vec3::Unit(i)).norm() <= largest_sine * axis.norm()) return i;
  }
  return std::nullopt;
}

/// Returns the box with its axes permuted so that the swimmer's axis comes first. If the swimmer points in
/// the negative direction, the coordinate along the axis is measured from the upper end of the box.
BoxPlace box_place(const Box& box, const Swimmer& swimmer, int axis) {
  const Vec3 position = wrapped(swimmer.position, box);
  BoxPlace place;
  for (int i = 0; i < 3; ++i) {
    const int from = (axis + i) % 3;
    const double length = box.lengths[from], x = position[from];
    place.box.lengths[i] = length;
    place.box.boundary[i] = box.boundary[from];
    place.middle_bead[i] = i == 0 && swimmer.axis[from] < 0 ? length - x : x;
  }
  return place;
}

/// Returns the reason why theory treats no swimmer in the box of the layout; an empty text if there is none.
std::string obstacle_of_box(const Layout& layout) {
  if (layout.swimmers.size() > 1) {
    return fmt::format(
        "the box holds {} swimmers, but theory treats only one swimmer per box; reduce a "
        "periodic scene to one swimmer with beadswim-layout reduce, or neglect the other "
        "swimmers in a layout without box ({})",
        layout.swimmers.size(), Setting::unbounded);
  }
  const auto& boundary = layout.domain.box->boundary;
  if (std::find(boundary.begin(), boundary.end(), Boundary::no_slip) != boundary.end())
    return "the box has no-slip walls, but theory treats only periodic and free-slip boundaries; make the "
           "layout with such boundaries";
  constexpr double max_aspect = 1e4;  // the number of terms of Ewald sums grows with the aspect ratio
  const Vec3& lengths = layout.domain.box->lengths;
  if (lengths.maxCoeff() <= max_aspect * lengths.minCoeff()) return {};
  return fmt::format(
      "the longest box edge is {:.3g} times the shortest, but theory sums images up to {:g} "
      "times; make the box shorter, or neglect it in a layout without box ({})",
      lengths.maxCoeff() / lengths.minCoeff(), max_aspect, Setting::unbounded);
}

}  // namespace

Surroundings surroundings_of(const Layout& layout, const Swimmer& swimmer) {
  if (!layout.domain.box) return {};
  if (std::string obstacle = obstacle_of_box(layout); !obstacle.empty()) return {.obstacle = obstacle};
  const std::optional<int> axis = coordinate_axis(swimmer.axis);
  if (!axis)
    return {.obstacle =
                "the swimmer is not parallel to a box axis, so the swimmer's images push it sideways; theory "
                "requires an axis along x, y or z"};
  return {.box = box_place(*layout.domain.box, swimmer, *axis)};
}

Surroundings surroundings_of_shape(const Layout& layout, const Vec3& place, NetForce net_force) {
  if (!layout.domain.box) return {};
  if (std::string obstacle = obstacle_of_box(layout); !obstacle.empty()) return {.obstacle = obstacle};
  if (net_force != NetForce::zero)
    return {.obstacle =
                "the driving forces do not sum to zero, so they would move the fluid in the box; give drives "
                "that sum to zero, or use a method without box"};
  return {.box = BoxPlace{*layout.domain.box, {place.x(), place.y(), place.z()}}};
}

}  // namespace beadswim
