#pragma once

#include <array>
#include <optional>
#include <vector>

#include "beadswim/core/vec3.hpp"

// The box that swimmers swim in, as the flow kernels see it. Any coherent unit system.

namespace beadswim {

/// A rectangular box, its corner in the origin. Each axis is periodic, or has free-slip walls at 0 and at its
/// length: no flow through them, no shear on them.
struct Box {
  std::array<double, 3> lengths{};  ///< along x, y, z [length]
  std::array<bool, 3> free_slip{};  ///< walls on this axis; else periodic
};

/// Edges of the periodic box in which walls are mirrors, twice as long across them; 0 without a box.
inline std::array<double, 3> mirrored_lengths(const std::optional<Box>& box) {
  std::array<double, 3> lengths{};
  if (!box) return lengths;
  for (int a = 0; a < 3; ++a) lengths[a] = box->lengths[a] * (box->free_slip[a] ? 2 : 1);
  return lengths;
}

/// Appends the copies behind walls of places, or of other vectors of as many beads: those of each axis in
/// turn, of which the mirror reverses the part across it.
inline void add_mirror_images(const std::optional<Box>& box, std::vector<Vec3>& vectors) {
  for (int a = 0; a < 3 && box; ++a) {
    if (!box->free_slip[a]) continue;
    const std::size_t count = vectors.size();
    for (std::size_t i = 0; i < count; ++i) {
      Vec3 mirrored = vectors[i];
      mirrored[a] = -mirrored[a];
      vectors.push_back(mirrored);
    }
  }
}

}  // namespace beadswim
