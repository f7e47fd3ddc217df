#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>
#include <vector>

#include "beadswim/core/fields.hpp"
#include "beadswim/core/names.hpp"
#include "beadswim/core/vec3.hpp"

// The domain that contains fluid and swimmers: a box with periodic and mirror images, or a half-space. All
// lengths have the same unit, which is not prescribed.

namespace beadswim {

/// Boundary condition at both ends of an axis of the box.
enum class Boundary {
  periodic,
  free_slip,  ///< wall without normal flow and without shear stress; it acts as a mirror
  no_slip,    ///< wall at which the fluid has the velocity of the wall
};

template <>
inline constexpr auto name_table<Boundary> = std::to_array<NamedValue<Boundary>>(
    {{Boundary::periodic, "periodic"}, {Boundary::free_slip, "free-slip"}, {Boundary::no_slip, "no-slip"}});

/// Velocities of the no-slip walls at both ends of an axis, parallel to the walls [length/time].
struct WallVelocities {
  Vec3 lower = Vec3::Zero(), upper = Vec3::Zero();

  bool are_moving() const { return !lower.isZero(0) || !upper.isZero(0); }
  WallVelocities operator/(double scale) const { return {.lower = lower / scale, .upper = upper / scale}; }

  bool operator==(const WallVelocities&) const = default;

  static void visit_fields(auto&& visit, auto& walls) {
    visit("lower_velocity", walls.lower);
    visit("upper_velocity", walls.upper);
  }
};

/// A rectangular box from the origin to `lengths`.
struct Box {
  Vec3 lengths = Vec3::Zero();            ///< edge lengths along x, y, z [length]
  std::array<Boundary, 3> boundary{};     ///< boundary condition of each axis
  std::array<WallVelocities, 3> walls{};  ///< zero along axes without no-slip walls

  bool is_periodic(int axis) const { return boundary[axis] == Boundary::periodic; }
  bool has_mirrors(int axis) const { return boundary[axis] == Boundary::free_slip; }

  bool operator==(const Box&) const = default;

  BEADSWIM_FIELDS(lengths, boundary, walls)
};

/// Fluid over a plane no-slip wall: where the coordinate along `axis` is above 0.
struct HalfSpace {
  int axis = 2;

  double height(const Vec3& position) const { return position[axis]; }
  Vec3 mirrored(Vec3 position) const {
    position[axis] = -position[axis];
    return position;
  }

  bool operator==(const HalfSpace&) const = default;

  BEADSWIM_FIELDS(axis)
};

/// Returns the half-space whose wall is across the axis "x", "y" or "z".
inline HalfSpace half_space_across(std::string_view axis) {
  return {.axis = static_cast<int>(std::string_view("xyz").find(axis))};
}

/// The part of space that the fluid fills: all of space if it has neither box nor half-space. It has at most
/// one of them.
struct Domain {
  std::optional<Box> box{};
  std::optional<HalfSpace> half_space{};

  bool operator==(const Domain&) const = default;

  BEADSWIM_FIELDS(box, half_space)
};

/// Returns, for each periodic axis, the number of the periodic copy of the box that contains the position:
/// the coordinate divided by the box length, rounded down, or one more where rounding would put the wrapped
/// coordinate on the upper end of the box. Returns 0 for each other axis.
inline Vec3 image_number(const Vec3& position, const Box& box) {
  Vec3 image = Vec3::Zero();
  for (int a = 0; a < 3; ++a) {
    if (!box.is_periodic(a)) continue;
    image[a] = std::floor(position[a] / box.lengths[a]);
    if (position[a] - box.lengths[a] * image[a] >= box.lengths[a]) ++image[a];
  }
  return image;
}

/// Returns the position with its periodic coordinates wrapped into the box, from 0 to below the box length.
/// Other coordinates, and all in open space (no box), are unchanged.
inline Vec3 wrapped(Vec3 position, const std::optional<Box>& box) {
  if (!box) return position;
  const Vec3 image = image_number(position, *box);
  for (int a = 0; a < 3; ++a)
    if (box->is_periodic(a)) position[a] = std::max(position[a] - box->lengths[a] * image[a], 0.0);
  return position;
}

/// Returns the vector from `from` to the nearest periodic image of `to`; in open space, to `to` itself
/// [length].
inline Vec3 nearest_separation(const Vec3& from, const Vec3& to, const std::optional<Box>& box) {
  Vec3 separation = to - from;
  for (int a = 0; a < 3 && box; ++a) {
    if (!box->is_periodic(a)) continue;
    const double length = box->lengths[a];
    if (std::abs(separation[a]) > length / 2) separation[a] -= length * std::round(separation[a] / length);
  }
  return separation;
}

/// Returns the edges of the larger box that the box and its mirror images form together [length]: twice the
/// box length along axes with free-slip walls, and the box length along other axes. In open space all edges
/// are 0.
inline Vec3 mirrored_lengths(const std::optional<Box>& box) {
  Vec3 lengths = Vec3::Zero();
  for (int a = 0; a < 3 && box; ++a) lengths[a] = box->lengths[a] * (box->has_mirrors(a) ? 2 : 1);
  return lengths;
}

/// Returns the number of axes with free-slip walls; each doubles the number of spheres in the mirrored box.
inline int mirror_count(const std::optional<Box>& box) {
  int count = 0;
  for (int a = 0; a < 3 && box; ++a) count += box->has_mirrors(a) ? 1 : 0;
  return count;
}

/// Appends to `vectors` (positions or other vectors) their mirror images at the free-slip walls through the
/// origin. Each axis with free-slip walls doubles the number of vectors: the component along this axis
/// changes sign in the image.
inline void add_mirror_images(const std::optional<Box>& box, std::vector<Vec3>& vectors) {
  for (int a = 0; a < 3 && box; ++a) {
    if (!box->has_mirrors(a)) continue;
    const std::size_t count = vectors.size();
    for (std::size_t i = 0; i < count; ++i) {
      Vec3 mirrored = vectors[i];
      mirrored[a] = -mirrored[a];
      vectors.push_back(mirrored);
    }
  }
}

}  // namespace beadswim
