#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "beadswim/core/vec3.hpp"

// Local map of the forces that makes the mobility of close beads exact along their lines:
//
//   S = exp(sum over pairs p of log S_p) blockdiag(S_swimmer),     v = S^T M S F
//
// Each S_swimmer and S_p acts on the components along its line e: S_ij = delta_ij I + (S_line - 1)_ij e e^T.
// Images behind walls mirror the forces of their beads, so only the equation of the bead is changed by a link
// between a bead and an image. A product of exponentials is never singular. The sum in the exponent does not
// depend on the order of the pairs.
//
// Page: docs/method/near-field.md.

namespace beadswim {

/// Change S - I of the three beads of a swimmer along its line.
struct SwimmerLink {
  Vec3 axis;  ///< unit vector
  Eigen::Matrix3d change;
};

/// log S_p of two beads, or of a bead and the image of its partner. With a = axis.f of the bead and
/// b = axis.(mirror * f) of the partner:
///
///   log S_p    adds own a + other b along the axis to the bead, and subtracts it from the partner
///   transpose  adds own (a - b) to the bead and other (a - b) to the partner
struct PairLink {
  int bead = 0, partner = 0;
  bool is_image =
      false;  ///< the partner is an image behind a wall: only the bead changes, the partner has its own link
  Vec3 mirror = Vec3::Ones();  ///< sign of each component; -1 across a wall
  Vec3 axis = Vec3::UnitX();   ///< unit vector of the line
  double own = 0, other = 0;   ///< first row of log S_p
};

class NearMap {
 public:
  /// swimmers[k] is the link of beads 3k, 3k + 1 and 3k + 2. All beads belong to a swimmer.
  NearMap(std::vector<SwimmerLink> swimmers, std::vector<PairLink> pairs);

  /// Replaces f by S f.
  void map_forces(std::span<Vec3> forces) const;

  /// Replaces v by S^T v.
  void map_velocities(std::span<Vec3> velocities) const;

  std::span<const PairLink> pairs() const { return pairs_; }

 private:
  template <class PairAction>
  void exponentiate(std::span<Vec3> vectors, const PairAction& increments) const;

  std::vector<SwimmerLink> swimmers_;
  std::vector<PairLink> pairs_;
  std::vector<int> linked_beads_;               ///< beads that belong to a pair
  std::vector<std::pair<int, int>> link_ends_;  ///< per pair, the indices of its beads in linked_beads_
  int parts_ = 1;  ///< exp(L) = exp(L/parts)^parts, where the norm of L/parts is at most 1
};

}  // namespace beadswim
