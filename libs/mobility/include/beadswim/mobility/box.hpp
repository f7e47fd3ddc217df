#pragma once

#include <array>
#include <optional>

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

}  // namespace beadswim
