#pragma once

#include <array>

#include "beadswim/layout/layout.hpp"

// What any model asks of a layout.

namespace beadswim {

/// The period that all swimmers share, else that of the first one's type [time].
double base_period(const Layout& layout);

/// Edges of the box and which of its axes are periodic; in unbounded fluid zero and none.
struct SceneBox {
  Vec3 lengths = Vec3::Zero();
  std::array<bool, 3> periodic{};
};
SceneBox box_of(const Layout& layout);

}  // namespace beadswim
