#pragma once

#include <Eigen/Core>

#include "beadswim/overdamped/overdamped_scene.hpp"
#include "beadswim/swimmers/swimmer_matrices.hpp"

// Views of lists of vectors per bead.

namespace beadswim {

/// Returns a view of the components x, y, z of the beads of one swimmer.
template <int Size>
auto swimmer_vector(const Beads& beads, const BeadRange& swimmer) {
  return Eigen::Map<const SwimmerVector<Size>>(beads[swimmer.first].data(),
                                               3 * (swimmer.last - swimmer.first));
}
template <int Size>
auto swimmer_vector(Beads& beads, const BeadRange& swimmer) {
  return Eigen::Map<SwimmerVector<Size>>(beads[swimmer.first].data(), 3 * (swimmer.last - swimmer.first));
}
/// Returns a view of the components x, y, z of all beads as one vector.
inline auto flat(const Beads& beads) {
  return Eigen::Map<const Eigen::VectorXd>(beads[0].data(), 3 * std::ssize(beads));
}
inline auto flat(Beads& beads) {
  return Eigen::Map<Eigen::VectorXd>(beads[0].data(), 3 * std::ssize(beads));
}
/// Returns a view of numbers as a vector.
inline auto flat(const std::vector<double>& numbers) {
  return Eigen::Map<const Eigen::VectorXd>(numbers.data(), std::ssize(numbers));
}
inline auto flat(std::vector<double>& numbers) {
  return Eigen::Map<Eigen::VectorXd>(numbers.data(), std::ssize(numbers));
}

}  // namespace beadswim
