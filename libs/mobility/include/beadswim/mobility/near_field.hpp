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

// Corrections that make the Rotne-Prager mobility of close beads exact along lines:
//
//   - The three beads of a swimmer are corrected along the line from bead 1 to bead 3, as if the swimmer were
//     straight with its present arm lengths.
//   - Any other pair of close beads is corrected along its line of centres. Periodic copies and mirror images
//     behind free-slip walls are included.
//
// A pair has full weight up to 4 mean radii between the centres. Its weight decreases to 0 at 6 mean radii.
// There the correction would change the relative velocity of two equal beads under opposite forces by 0.4 %,
// at 8 mean radii by 0.1 %. The neglected effect of a third bead is as large.
//
// Page: docs/method/near-field.md.

namespace beadswim {

/// Distances between the centres that limit the pair correction [mean radius of the pair].
constexpr double full_weight_distance = 4, pair_cutoff = 6;

/// Returns the weight of a pair at `distance` [mean radius]: 1 up to full_weight_distance, 0 from
/// pair_cutoff. The weight is twice continuously differentiable.
double pair_weight(double distance);

class NearField {
 public:
  /// `radii` holds the radii of swimmer k at 3k, 3k + 1 and 3k + 2 [length]. Throws InputError if their
  /// number is not a multiple of three.
  NearField(std::vector<double> radii, std::optional<Box> box);

  /// Returns the map S for spheres at these positions [length]. Throws NotFiniteError as multipole_mobility
  /// does. Fills tables on demand, so concurrent calls are not allowed.
  NearMap at(std::span<const Vec3> positions) const;

 private:
  /// Positions of the beads and of their mirror images behind walls.
  struct Images {
    std::vector<Vec3> places;
    std::vector<Vec3> mirrors;  ///< signs of the components, one per set of images
  };
  Images mirror_images(std::span<const Vec3> positions) const;
  SwimmerLink swimmer_link(std::size_t swimmer, std::span<const Vec3> positions) const;
  std::vector<PairLink> pair_links(std::span<const Vec3> positions) const;
  void add_pair(const Images& images, int one, int other, const Vec3& separation,
                std::vector<PairLink>& links) const;
  const PairMapTable& pair_table(int bead, int partner) const;

  std::vector<double> radii_;
  std::optional<Box> box_;
  Vec3 lengths_;  ///< periodic box that contains the mirror images; 0 in open space [length]
  std::vector<TripletMapTable> triplet_tables_;
  std::vector<int> triplet_table_of_;  ///< index into triplet_tables_, per swimmer
  mutable std::map<std::array<double, 2>, PairMapTable> pair_tables_;
};

}  // namespace beadswim
