#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "beadswim/core/cell_list.hpp"
#include "beadswim/scene/layout.hpp"

// Distances between the beads of a scene at rest, periodic images included. Cell lists: the cost grows as the
// number of beads.

namespace beadswim {

/// One bead of a scene at rest.
struct PlacedBead {
  Vec3 centre;              ///< unwrapped [length]
  double radius = 0;        ///< [length]
  std::size_t swimmer = 0;  ///< index in Layout::swimmers
  int bead = 0;             ///< 0, 1 or 2
};

/// Three beads a swimmer, in order. Every swimmer's type must exist.
std::vector<PlacedBead> placed_beads(const Layout& layout);

/// Two beads, or one and its own periodic image (first == second).
struct BeadPair {
  std::size_t first = 0;   ///< index in the list of beads
  std::size_t second = 0;  ///< not greater than `first`
  double distance = 0;     ///< between centres of the nearest images [length]
};

/// Returns the radius of the largest bead [length].
double largest_radius(const std::vector<PlacedBead>& beads);

/// Sorts the centres of the beads, one at least, into cells that find what is within `reach` of a point
/// [length]. Walls are crossed as periodic faces are, so it may find more.
CellList bead_cells(const std::vector<PlacedBead>& beads, const std::optional<Box>& domain, double reach);

/// Calls visit(pair) for each pair of beads, and maybe some more, whose nearest images have centres within
/// `reach` [length], until visit returns false. Pairs come in ascending order of `first`, then of `second`.
void visit_close_pairs(const std::vector<PlacedBead>& beads, const std::optional<Box>& domain, double reach,
                       const std::function<bool(const BeadPair&)>& visit);

/// Pairs whose surfaces touch or cross, at most `most` of them.
std::vector<BeadPair> overlapping_pairs(const std::vector<PlacedBead>& beads,
                                        const std::optional<Box>& domain, std::size_t most);

/// Smallest distance between two surfaces: beads, their periodic images, and walls [length].
double smallest_gap(const std::vector<PlacedBead>& beads, const std::optional<Box>& domain);

}  // namespace beadswim
