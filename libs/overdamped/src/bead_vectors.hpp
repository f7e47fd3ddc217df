#pragma once

#include "beadswim/overdamped/overdamped_scene.hpp"
#include "swimmer_response.hpp"

// Vectors of all beads as Eigen has them.

namespace beadswim {

/// The nine numbers of a swimmer.
inline auto nine(const Beads& beads, std::size_t swimmer) {
  return Eigen::Map<const Vector9>(beads[3 * swimmer].data());
}
inline auto nine(Beads& beads, std::size_t swimmer) {
  return Eigen::Map<Vector9>(beads[3 * swimmer].data());
}
/// All as one vector.
inline auto flat(const Beads& beads) {
  return Eigen::Map<const Eigen::VectorXd>(beads[0].data(), 3 * std::ssize(beads));
}
inline auto flat(Beads& beads) {
  return Eigen::Map<Eigen::VectorXd>(beads[0].data(), 3 * std::ssize(beads));
}

}  // namespace beadswim
