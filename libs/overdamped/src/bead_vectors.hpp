#pragma once

#include "beadswim/overdamped/overdamped_scene.hpp"
#include "swimmer_response.hpp"

// Views of the vectors of all beads as Eigen vectors.

namespace beadswim {

/// Returns a view of the nine components of one swimmer.
inline auto swimmer_vector(const Beads& beads, std::size_t swimmer) {
  return Eigen::Map<const Vector9>(beads[3 * swimmer].data());
}
inline auto swimmer_vector(Beads& beads, std::size_t swimmer) {
  return Eigen::Map<Vector9>(beads[3 * swimmer].data());
}
/// Returns a view of the components of all beads.
inline auto flat(const Beads& beads) {
  return Eigen::Map<const Eigen::VectorXd>(beads[0].data(), 3 * std::ssize(beads));
}
inline auto flat(Beads& beads) {
  return Eigen::Map<Eigen::VectorXd>(beads[0].data(), 3 * std::ssize(beads));
}

}  // namespace beadswim
