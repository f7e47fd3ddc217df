#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "beadswim/core/vec3.hpp"

// Map S of the forces that makes the mobility of close beads exact along the lines between them:
//
//   S = exp(sum over pairs p of log S_p) blockdiag(S_swimmer),     v = S^T M S F
//
//   M, F, v    Rotne-Prager mobility, forces and velocities of all beads
//   S_swimmer  map of the three beads of one swimmer;  S_p  map of the two beads of pair p
//   S_line     map of these beads along their line (line_map.hpp);  e  unit vector along this line
//
// S_swimmer and S_p change only the components along e. Their 3 x 3 blocks for the beads i and j are
//
//   S_ij = delta_ij I + (S_line - I)_ij e e^T
//
// A mirror image behind a wall carries the mirrored force of its bead. A link between a bead and a mirror
// image therefore changes only the force on the bead. S is never singular, because all its factors are
// invertible. The sum in the exponent does not depend on the order of the pairs.
//
// Page: docs/method/near-field.md.

namespace beadswim {

/// Change S_line - I of the three beads of a swimmer along its line.
struct SwimmerLink {
  Vec3 axis;  ///< e, from bead 1 to bead 3
  Eigen::Matrix3d change;
};

/// log S_p of two beads, or of a bead and an image of its partner. f is the vector that is mapped (forces or
/// velocities). With a = axis.f of the bead and b = axis.(mirror * f) of the partner:
///
///   log S_p    adds  (own a + other b) axis  to the f of the bead and subtracts it from the f of the partner
///   transpose  adds  own (a - b) axis  to the f of the bead and  other (a - b) axis  to the f of the partner
struct PairLink {
  int bead = 0, partner = 0;
  /// The partner is represented by a mirror image behind a wall. The link then changes only the bead. Another
  /// link changes the partner.
  bool is_image = false;
  Vec3 mirror = Vec3::Ones();  ///< sign of each component; -1 across a wall
  Vec3 axis = Vec3::UnitX();   ///< unit vector of the line
  double own = 0, other = 0;   ///< first row of log S_p
};

class NearMap {
 public:
  /// swimmers[k] is the link of beads 3k, 3k + 1 and 3k + 2. Each bead belongs to one swimmer.
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
  /// exp(L) is evaluated as exp(L/parts_)^parts_, where L is the sum of log S_p. The norm of L/parts_ is at
  /// most 1.
  int parts_ = 1;
};

}  // namespace beadswim
