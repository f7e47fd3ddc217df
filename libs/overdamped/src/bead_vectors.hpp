#pragma once

#include <vector>

#include "swimmer_response.hpp"

// Numbers of all beads, three vectors a swimmer.

namespace beadswim {

using Beads = std::vector<Vec3>;

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
