#pragma once

#include "beadswim/overdamped/overdamped_scene.hpp"
#include "swimmer_response.hpp"

// Functions that view lists of bead vectors as Eigen vectors, without a copy.

namespace beadswim {

/// Returns a view of the nine components x, y, z of the beads 1, 2, 3 of the swimmer with index `swimmer`.
inline auto swimmer_vector(const Beads& beads, std::size_t swimmer) {
  return Eigen::Map<const Vector9>(beads[3 * swimmer].data());
}
inline auto swimmer_vector(Beads& beads, std::size_t swimmer) {
  return Eigen::Map<Vector9>(beads[3 * swimmer].data());
}
/// Returns a view of the components x, y, z of all beads as one vector.
inline auto flat(const Beads& beads) {
  return Eigen::Map<const Eigen::VectorXd>(beads[0].data(), 3 * std::ssize(beads));
}
inline auto flat(Beads& beads) {
  return Eigen::Map<Eigen::VectorXd>(beads[0].data(), 3 * std::ssize(beads));
}

}  // namespace beadswim
