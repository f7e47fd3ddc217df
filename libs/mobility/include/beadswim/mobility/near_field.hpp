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

// Which beads are near each other, and what makes Rotne and Prager's mobility of them exact: each swimmer's
// own three as if straight, of its two arms' lengths along the line from bead 1 to bead 3; any other two,
// periodic copies and mirror images behind free-slip walls among them, along their line of centres.
//
// Pairs count in full up to 4 mean radii between centres and fade out up to 6, where they would change how
// fast two equal beads part by opposite forces by 0.4 %, at 8 by 0.1 %: what a third bead does is as large.
//
// Page: docs/method/near-field.md.

namespace beadswim {

constexpr double full_pair_reach = 4, pair_reach = 6;  ///< between centres [mean radius of the two]

/// Weight of a pair by its distance in mean radii: 1 within full_pair_reach, 0 beyond pair_reach, twice
/// differentiable.
double pair_weight(double distance);

class NearField {
 public:
  /// radii: of spheres 3k, 3k + 1, 3k + 2 of swimmer k. Throws InputError if there is one left over.
  NearField(std::vector<double> radii, std::optional<Box> box);

  /// S for spheres at these places. Throws NotFiniteError as multipole_mobility does. Tables fill as they are
  /// asked for: not for threads side by side.
  NearMap at(std::span<const Vec3> positions) const;

 private:
  /// The places, and those of all mirror images behind walls.
  struct Images {
    std::vector<Vec3> places;
    std::vector<Vec3> mirrors;  ///< of each run of places, as many as there are beads
  };
  Images images_of(std::span<const Vec3> positions) const;
  SwimmerLink swimmer_link(std::size_t swimmer, std::span<const Vec3> positions) const;
  std::vector<PairLink> pair_links(std::span<const Vec3> positions) const;
  void add_pair(const Images& images, int one, int other, const Vec3& separation,
                std::vector<PairLink>& links) const;
  const PairMapTable& pair_table(int bead, int partner) const;

  std::vector<double> radii_;
  std::optional<Box> box_;
  Vec3 lengths_;  ///< of the periodic box of all images; 0 without
  std::vector<TripletMapTable> triplet_tables_;
  std::vector<int> triplet_table_of_;  ///< each swimmer
  mutable std::map<std::array<double, 2>, PairMapTable> pair_tables_;
};

}  // namespace beadswim
