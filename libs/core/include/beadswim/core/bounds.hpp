#pragma once

#include <span>

#include "beadswim/core/vec3.hpp"

namespace beadswim {

/// Smallest axis-aligned box that contains all given points. There must be at least one point.
struct Bounds {
  Vec3 low, high;

  explicit Bounds(std::span<const Vec3> places) : low(places[0]), high(places[0]) {
    for (const Vec3& place : places) {
      low = low.cwiseMin(place);
      high = high.cwiseMax(place);
    }
  }
};

}  // namespace beadswim
