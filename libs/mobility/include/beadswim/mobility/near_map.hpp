#pragma once

#include <Eigen/Core>
#include <array>
#include <span>
#include <vector>

#include "beadswim/core/vec3.hpp"

// Velocities v of beads by forces F on them, of which those on close beads and on beads over a plane no-slip
// wall induce stresslets H (force_moments.hpp). A map S of the forces, and S^T of the velocities, make the
// result exact along the lines between close beads and across the wall:
//
//   v = S^T ([I; -K]^T A [I; -K] - T) S F,    K_ij = w_ij D_i^-1 (M_HF)_ij,    T = sum over groups g of tau u
//   u^T S = exp(sum over pairs p of log S_p + sum over beads w of log S_w) blockdiag(S_three)
//
//   A           matrix of the forces and stresslets on all beads, [M_FF, M_FH; M_HF, M_HH]
//   K           -K maps forces to the stresslets that they induce on close beads
//   D_i         block M_HH of bead i alone, over its wall;  w_ij: weight, 0 for distant beads
//   T           the velocity that S leaves of beads under a net force: tau of line_map.hpp
//   g           a pair, or three beads of a swimmer on a line;  u: e for each of its beads, 0 for others
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
// its bead, so S_p then changes only the force on the bead that is not an image. The sum in the exponent does
// not depend on the order of the pairs.
//
// S is never singular, because all its factors are invertible. So the mobility without T is symmetric and
// positive definite for any K, because A is. With T, tests of crowds and crystals show it.
//
// Page: docs/method/near-field.md.

namespace beadswim {

/// Correction of the forces on three beads on a line. If a contains the components of the forces
/// along `axis`, the correction adds `change` a to a, where `change` is S_line - I (line_map.hpp).
struct LineLink {
  int first = 0;  ///< index of bead 1
  Vec3 axis;      ///< unit vector from bead 1 to bead 3
  Eigen::Matrix3d change;
  double tow_defect = 0;  ///< tau [time/mass]
};

/// Matrix log S_p that corrects the forces on two close beads, or on a bead and an image of its partner. It
/// is applied to vectors f of the beads (forces or velocities). With the components a = axis.f of the bead
/// and b = axis.(mirror * f) of the partner, the products are
///
///   log S_p f       (own a + other b) axis for the bead, minus this vector for the partner
///   (log S_p)^T f   own (a - b) axis for the bead, other (a - b) axis for the partner
///   T f             tow_defect (a + b) axis for both
struct PairLink {
  int bead = 0, partner = 0;
  /// True if the partner is represented by its mirror image behind a wall. This link then changes only the
  /// vector of the bead. Another link changes the vector of the partner.
  bool is_image = false;
  Vec3 mirror = Vec3::Ones();  ///< sign of each component of the image; -1 if a wall mirrors it
  Vec3 axis = Vec3::UnitX();   ///< unit vector along the line of centres
  double own = 0, other = 0;   ///< first row of the 2 x 2 matrix log S_line of the pair, times its weight
  double tow_defect = 0;       ///< tau of the pair, times its weight [time/mass]
};

/// Matrix log S_w that corrects the force on a bead over a plane no-slip wall. It is symmetric:
///
///   log S_w f = log (normal.f) normal
struct WallLink {
  int bead = 0;
  Vec3 normal = Vec3::UnitZ();  ///< unit vector across the wall
  double log = 0;               ///< log s (wall_map.hpp)
};

/// Rates of strain of two beads by the forces on each other in open space, or of a bead by the force on an
/// image of its partner, times the weight w. The force F causes the symmetric, traceless part of
///
///   e (2 p F + q (e.F) e)^T
///
/// For the partner, e points the other way.
struct StrainLink {
  int bead = 0, partner = 0;
  bool is_image = false;           ///< true: the partner is represented by its image, and is not strained
  Vec3 mirror = Vec3::Ones();      ///< as in PairLink
  Vec3 axis = Vec3::UnitX();       ///< e, from the partner to the bead
  std::array<double, 2> p{}, q{};  ///< of the bead and of the partner [time/(mass length)]
};

/// Rate of strain of a bead by the flow that the wall reflects of the force on a bead, times the weight w:
/// its projections on the stresslets of the bead (force_moments.hpp).
struct WallStrainLink {
  int strained = 0, forced = 0;
  Eigen::Matrix<double, 5, 3> strain;
};

/// Links of beads at some positions, and the number of the beads. Each bead belongs to at most one line.
struct NearLinks {
  std::size_t beads = 0;
  std::vector<LineLink> lines{};
  std::vector<PairLink> pairs{};
  std::vector<WallLink> walls{};
  std::vector<StrainLink> strains{};
  std::vector<WallStrainLink> wall_strains{};
  std::vector<Eigen::Matrix<double, 5, 5>> resistances{};  ///< D_i^-1 of each bead, if there are strains
};

class NearMap {
 public:
  explicit NearMap(NearLinks links);

  /// Returns the highest moment of the forces in A: 1, or 0 if no forces induce stresslets.
  int moment_order() const { return links_.strains.empty() && links_.wall_strains.empty() ? 0 : 1; }

  /// Returns the moments [I; -K] S F, moment_count() numbers per bead each, by the forces F on all beads.
  std::vector<double> moments_of(std::span<const Vec3> forces) const;

  /// Sets `velocities` to S^T ([I; -K]^T U - T f). f: forces in `moments`, U: `projections` of their flow.
  void set_velocities(std::span<const double> moments, std::span<const double> projections,
                      std::span<Vec3> velocities) const;

 private:
  template <class PairAction>
  void exponentiate(std::span<Vec3> vectors, const PairAction& increments) const;

  void add_stresslets(std::span<const Vec3> forces, std::span<double> moments) const;
  void add_velocities_by_strains(std::span<const double> projections, std::span<Vec3> velocities) const;
  void subtract_tow_defects(std::span<const Vec3> forces, std::span<Vec3> velocities) const;

  NearLinks links_;
  std::vector<int> linked_beads_;               ///< beads that belong to a pair or are over a wall
  std::vector<std::pair<int, int>> link_ends_;  ///< per pair, the indices of its beads in linked_beads_
  std::vector<int> wall_ends_;                  ///< per wall link, the index of its bead in linked_beads_
  /// Number of factors by which exp(L) is evaluated, exp(L) = exp(L/parts_)^parts_, where L is the sum of log
  /// S_p over all pairs p and of log S_w over all beads w. The norm of L/parts_ is at most 1.
  int parts_ = 1;
};

}  // namespace beadswim
