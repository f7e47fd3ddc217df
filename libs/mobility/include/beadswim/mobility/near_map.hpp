#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "beadswim/core/vec3.hpp"

// The local map of forces that makes near beads' mobility exact along their lines,
//
//   S = exp(sum over pairs p of log S_p) blockdiag(S_swimmer),     v = S^T M S F
//
// Each S_swimmer and S_p acts on parts along its line, S_ij = delta_ij I + (S_line - 1)_ij e e^T. Beads
// behind walls are mirrored copies: what they do to a bead is told by links of the bead alone, to copies
// nothing needs to be done. A product of exponentials is never singular, and the sum in it has no order.
//
// Page: docs/method/near-field.md.

namespace beadswim {

/// S - I of a swimmer's beads along its line.
struct SwimmerLink {
  Vec3 axis;  ///< unit vector
  Eigen::Matrix3d change;
};

/// log S_p of two beads, or of a bead and an image. With a = axis.f of the bead and b = axis.(mirror * f) of
/// its partner the bead gains own a + other b along the axis, its partner the opposite; by the transpose own
/// (a - b) and other (a - b).
struct PairLink {
  int bead = 0, partner = 0;
  bool is_image =
      false;  ///< of the partner, behind a wall: the bead's row alone, the partner has one of its own
  Vec3 mirror = Vec3::Ones();  ///< by components, -1 across a wall
  Vec3 axis = Vec3::UnitX();   ///< unit vector
  double own = 0, other = 0;
};

class NearMap {
 public:
  /// swimmers[k]: of beads 3k, 3k + 1, 3k + 2, all of them.
  NearMap(std::vector<SwimmerLink> swimmers, std::vector<PairLink> pairs);

  /// f becomes S f.
  void map_forces(std::span<Vec3> forces) const;

  /// v becomes S^T v.
  void map_velocities(std::span<Vec3> velocities) const;

  std::span<const PairLink> pairs() const { return pairs_; }

 private:
  template <class Gains>
  void exponentiate(std::span<Vec3> vectors, const Gains& gains) const;

  std::vector<SwimmerLink> swimmers_;
  std::vector<PairLink> pairs_;
  std::vector<int> linked_;                ///< beads that are in a pair
  std::vector<std::pair<int, int>> ends_;  ///< of each pair, the places of its beads in linked_
  int parts_ = 1;  ///< exp(L) is taken as exp(L/parts)^parts, norm of L/parts at most 1
};

}  // namespace beadswim
