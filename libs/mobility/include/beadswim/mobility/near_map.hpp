#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "beadswim/core/vec3.hpp"

// Map S of the forces on all beads, and map S^T of their velocities. The two maps make the Rotne-Prager
// mobility M of close beads exact along the lines between them, and that of beads over a plane no-slip wall
// across it:
//
//   S = exp(sum over pairs p of log S_p + sum over beads w of log S_w) blockdiag(S_three),    v = S^T M S F
//
//   F, v        forces on all beads, velocities of all beads
//   S_three     map of the forces on three beads of a swimmer that stay on a line
//   blockdiag   block-diagonal matrix with one S_three for each such swimmer, and 1 for other beads
//   S_p         map of the forces on the two beads of a close pair p
//   S_w         map of the force on the bead w over a wall (wall_map.hpp)
//   S_line      matrix that maps the components of these three or two forces along the line of their beads
//               (line_map.hpp)
//   e           unit vector along this line
//
// S_three and S_p change only the components of the forces along e. The force on bead i after the map
// depends on the force on bead j before the map by the 3 x 3 matrix
//
//   S_ij = delta_ij I + (S_line - I)_ij e e^T
//
// A pair may also consist of a bead and a mirror image behind a wall. The image carries the mirrored force of
// its bead, so S_p then changes only the force on the bead that is not an image. S is never singular, because
// all its factors are invertible. The sum in the exponent does not depend on the order of the pairs.
//
// Page: docs/method/near-field.md.

namespace beadswim {

/// Correction of the forces on three beads on a line. If a contains the components of the forces
/// along `axis`, the correction adds `change` a to a, where `change` is S_line - I (line_map.hpp).
struct LineLink {
  int first = 0;  ///< index of bead 1
  Vec3 axis;      ///< unit vector from bead 1 to bead 3
  Eigen::Matrix3d change;
};

/// Matrix log S_p that corrects the forces on two close beads, or on a bead and an image of its partner. It
/// is applied to vectors f of the beads (forces or velocities). With the components a = axis.f of the bead
/// and b = axis.(mirror * f) of the partner, the products are
///
///   log S_p f       (own a + other b) axis for the bead, minus this vector for the partner
///   (log S_p)^T f   own (a - b) axis for the bead, other (a - b) axis for the partner
struct PairLink {
  int bead = 0, partner = 0;
  /// True if the partner is represented by its mirror image behind a wall. This link then changes only the
  /// vector of the bead. Another link changes the vector of the partner.
  bool is_image = false;
  Vec3 mirror = Vec3::Ones();  ///< sign of each component of the image; -1 if a wall mirrors it
  Vec3 axis = Vec3::UnitX();   ///< unit vector along the line of centres
  double own = 0, other = 0;   ///< first row of the 2 x 2 matrix log S_line of the pair, times its weight
};

/// Matrix log S_w that corrects the force on a bead over a plane no-slip wall. It is symmetric:
///
///   log S_w f = log (normal.f) normal
struct WallLink {
  int bead = 0;
  Vec3 normal = Vec3::UnitZ();  ///< unit vector across the wall
  double log = 0;               ///< log s (wall_map.hpp)
};

class NearMap {
 public:
  /// Sets up the map S of `beads` beads. Each bead belongs to at most one line.
  NearMap(std::vector<LineLink> lines, std::vector<PairLink> pairs, std::vector<WallLink> walls,
          std::size_t beads);

  /// Replaces the forces f on all beads by S f.
  void map_forces(std::span<Vec3> forces) const;

  /// Replaces the velocities v of all beads by S^T v.
  void map_velocities(std::span<Vec3> velocities) const;

  std::span<const PairLink> pairs() const { return pairs_; }

 private:
  template <class PairAction>
  void exponentiate(std::span<Vec3> vectors, const PairAction& increments) const;

  std::vector<LineLink> lines_;
  std::vector<PairLink> pairs_;
  std::vector<WallLink> walls_;
  std::vector<int> linked_beads_;               ///< beads that belong to a pair or are over a wall
  std::vector<std::pair<int, int>> link_ends_;  ///< per pair, the indices of its beads in linked_beads_
  std::vector<int> wall_ends_;                  ///< per wall link, the index of its bead in linked_beads_
  /// Number of factors by which exp(L) is evaluated, exp(L) = exp(L/parts_)^parts_, where L is the sum of log
  /// S_p over all pairs p and of log S_w over all beads w. The norm of L/parts_ is at most 1.
  int parts_ = 1;
};

}  // namespace beadswim
