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
#include "beadswim/mobility/wall_map.hpp"

// Corrections that make the Rotne-Prager mobility of close beads exact along the lines between the beads:
//
//   - Three beads of a swimmer that stay on a line are corrected along the line from bead 1 to bead 3. The
//     correction is evaluated for a straight swimmer with the same arm lengths.
//   - Any other pair of close beads is corrected along its line of centres. One bead of the pair may be a
//     periodic copy of a bead, or the mirror image of a bead behind a free-slip wall.
//   - A bead over the no-slip wall of a half-space is corrected across the wall (wall_map.hpp).
//
// The correction of a pair has full weight up to a distance of 4 mean radii of the pair between the centres.
// The weight decreases to 0 at 6 mean radii. There, the full correction would change the relative velocity of
// two equal beads under opposite forces by 0.4 %. At 8 mean radii it would change this velocity by 0.1 %.
// Both changes are as small as the effect of a third bead, which is neglected.
//
// Page: docs/method/near-field.md.

namespace beadswim {

/// Distances between the centres of two beads at which the weight of their near-field correction starts to
/// decrease from 1, and at which it becomes 0 [mean radius of the two beads].
constexpr double full_weight_distance = 4, pair_cutoff = 6;

/// Returns the weight of the near-field correction of two beads whose centres are `distance` apart [mean
/// radius of the two beads]: 1 up to full_weight_distance, 0 from pair_cutoff. The weight is twice
/// continuously differentiable.
double pair_weight(double distance);

class NearField {
 public:
  /// Sets up the correction for spheres with these radii [length]. lines: as in
  /// MobilityScene.
  NearField(std::vector<double> radii, std::vector<int> lines, std::optional<Box> box,
            std::optional<HalfSpace> half_space);

  /// Returns the map S of the forces on all beads (near_map.hpp) for beads at `positions` [length]. Throws
  /// NotFiniteError if multipole_mobility() throws it. Computes nodes of tables when they are first needed,
  /// so concurrent calls are not allowed.
  NearMap at(std::span<const Vec3> positions) const;

 private:
  /// Positions of the beads and of their mirror images behind walls.
  struct Images {
    std::vector<Vec3> places;
    std::vector<Vec3> mirrors;  ///< per set of images: sign of each vector component, -1 if it is mirrored
  };
  Images mirror_images(std::span<const Vec3> positions) const;
  LineLink line_link(std::size_t line, std::span<const Vec3> positions) const;
  std::vector<PairLink> pair_links(std::span<const Vec3> positions) const;
  void add_pair(const Images& images, int one, int other, const Vec3& separation,
                std::vector<PairLink>& links) const;
  std::vector<WallLink> wall_links(std::span<const Vec3> positions) const;
  const PairMapTable& pair_table(int bead, int partner) const;

  std::vector<double> radii_;
  std::vector<int> lines_;    ///< index of the first bead of each line
  std::vector<int> line_of_;  ///< index of the line of each bead; -1: none
  std::optional<Box> box_;
  std::optional<HalfSpace> half_space_;
  Vec3 lengths_;  ///< edges of the periodic box that contains the mirror images [length]; 0: open space
  std::vector<TripletMapTable> triplet_tables_;
  std::vector<int> triplet_table_of_;  ///< index into triplet_tables_, per line
  mutable std::map<std::array<double, 2>, PairMapTable> pair_tables_;
  WallMapTable wall_table_;
};

}  // namespace beadswim
