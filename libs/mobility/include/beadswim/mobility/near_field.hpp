#pragma once

#include <array>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "beadswim/core/box.hpp"
#include "beadswim/core/vec3.hpp"
#include "beadswim/mobility/line_map_table.hpp"
#include "beadswim/mobility/near_map.hpp"

// Corrections of the Rotne-Prager mobility of close beads (near_map.hpp). Forces on close beads, and on beads
// near a no-slip wall, induce stresslets. What they leave is corrected, so that the mobility becomes exact
// along the lines between the beads:
//
//   - Three beads of a swimmer that stay on a line are corrected along the line from bead 1 to bead 3. The
//     correction is evaluated for a straight swimmer with the same arm lengths.
//   - Any other pair of close beads is corrected along its line of centres. One bead of the pair may be a
//     periodic copy of a bead, or the mirror image of a bead behind a free-slip wall.
//   - A bead over the no-slip wall of a half-space is corrected across the wall (wall_map.hpp).
//
// The correction of a pair has full weight up to a distance of 4 mean radii of the pair between the centres.
// The weight decreases to 0 at 6 mean radii. There, the full correction would change the relative velocity of
// two equal beads under opposite forces by 0.4 %.
//
// Page: docs/method/near-field.md.

namespace beadswim {

class NearStrains;

/// Distances between the centres of two beads at which the weight of their near-field correction starts to
/// decrease from 1, and at which it becomes 0 [mean radius of the two beads].
constexpr double full_weight_distance = 4, pair_cutoff = 6;

/// Returns the weight of the near-field correction of two beads whose centres are `distance` apart [mean
/// radius of the two beads]: 1 up to full_weight_distance, 0 from pair_cutoff. The weight is twice
/// continuously differentiable.
double pair_weight(double distance);

/// Stresslets reach farther than the other corrections by this factor: a weight that changes with the stroke
/// changes the slopes of the mobility, and so velocities in a dense swarm. In the unit cell of the paper's
/// swarm, from which it was chosen, the factor 2 gives 17.24e-5, 3 gives 15.28e-5, and force moments of order
/// 2 give 15.11e-5.
constexpr double strain_reach = 3;

/// Returns the weight of stresslets that two beads induce on each other: pair_weight(distance/strain_reach).
double strain_weight(double distance);

class NearField {
 public:
  /// Sets up the correction for spheres with these radii [length]. lines: as in
  /// MobilityScene.
  NearField(std::vector<double> radii, std::vector<int> lines, double viscosity, Domain domain);

  /// Returns the corrections for beads at `positions` [length]. Throws NotFiniteError if multipole_mobility()
  /// throws it.
  NearMap at(std::span<const Vec3> positions);

 private:
  /// Positions of the beads and of their mirror images behind walls.
  struct Images {
    std::vector<Vec3> places;
    std::vector<Vec3> mirrors;  ///< per set of images: sign of each vector component, -1 if it is mirrored
  };
  Images mirror_images(std::span<const Vec3> positions) const;
  LineLink line_link(std::size_t line, std::span<const Vec3> positions);
  void add_pairs(std::span<const Vec3> positions, NearStrains& strains, std::vector<PairLink>& links);
  PairLink pair_link(const Images& images, int one, int other, const Vec3& separation, double weight);
  LineMapTable<2>& pair_table(int bead, int partner);

  std::vector<double> radii_;
  std::vector<int> lines_;    ///< index of the first bead of each line
  std::vector<int> line_of_;  ///< index of the line of each bead; -1: none
  double viscosity_;
  Domain domain_;
  Vec3 lengths_;  ///< edges of the periodic box that contains the mirror images [length]; 0: open space
  std::vector<LineMapTable<3>> triplet_tables_;
  std::vector<int> triplet_table_of_;  ///< index into triplet_tables_, per line
  std::map<std::array<double, 2>, LineMapTable<2>> pair_tables_;
};

}  // namespace beadswim
