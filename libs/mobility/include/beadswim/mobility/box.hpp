#pragma once

#include <array>

// The box that swimmers swim in, as the flow kernels see it. Any coherent unit system.

namespace beadswim {

/// A rectangular box, its corner in the origin. Each axis is periodic, or has free-slip walls at 0 and at its
/// length: no flow through them, no shear on them.
struct Box {
  std::array<double, 3> lengths{};  ///< along x, y, z [length]
  std::array<bool, 3> free_slip{};  ///< walls on this axis; else periodic
};

}  // namespace beadswim
