#pragma once

#include <string_view>

#include "beadswim/core/vec3.hpp"

namespace beadswim {

/// Fluid over a plane no-slip wall: where the coordinate along `axis` is above 0.
struct HalfSpace {
  int axis = 2;

  double height(const Vec3& position) const { return position[axis]; }
  Vec3 mirrored(Vec3 position) const {
    position[axis] = -position[axis];
    return position;
  }

  bool operator==(const HalfSpace&) const = default;

  static void visit_fields(auto&& visit, auto& half_space) { visit("axis", half_space.axis); }
};

/// Returns the half-space whose wall is across the axis "x", "y" or "z".
inline HalfSpace half_space_across(std::string_view axis) {
  return {.axis = static_cast<int>(std::string_view("xyz").find(axis))};
}

}  // namespace beadswim
