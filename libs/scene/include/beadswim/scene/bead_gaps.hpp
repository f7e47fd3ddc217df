#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "beadswim/core/cell_list.hpp"
#include "beadswim/scene/layout.hpp"

// Distances between the beads of a scene at rest. Periodic images are included. Cell lists make the cost
// proportional to the number of beads.

namespace beadswim {

/// One bead of a scene at rest.
struct PlacedBead {
  Vec3 centre;              ///< unwrapped [length]
  double radius = 0;        ///< [length]
  std::size_t swimmer = 0;  ///< index in Layout::swimmers
  int bead = 0;             ///< 0, 1 or 2
};

/// Returns the beads of all swimmers, three per swimmer, in order of the swimmers. The type of every swimmer
/// must exist in the layout.
std::vector<PlacedBead> placed_beads(const Layout& layout);

/// A pair of beads, or a bead and its own periodic image (first == second).
struct BeadPair {
  std::size_t first = 0;   ///< index in the list of beads
  std::size_t second = 0;  ///< not greater than `first`
  double distance = 0;     ///< between the centres of the nearest images [length]
};

/// Returns the radius of the largest bead [length].
double largest_radius(const std::vector<PlacedBead>& beads);

/// Sorts the centres of the beads (at least one) into cells that find all centres within `cutoff` [length] of
/// a point. The cells treat walls as periodic faces, so the search may find more centres.
CellList bead_cells(const std::vector<PlacedBead>& beads, const std::optional<Box>& domain, double cutoff);

/// Calls visit(pair) for each pair of beads whose nearest images have centres within `cutoff` [length], until
/// visit returns false. May also visit pairs beyond the cutoff. Pairs come in ascending order of `first`,
/// then of `second`.
void visit_close_pairs(const std::vector<PlacedBead>& beads, const std::optional<Box>& domain, double cutoff,
                       const std::function<bool(const BeadPair&)>& visit);

/// Returns the pairs whose surfaces touch or intersect, at most `max_pairs` pairs. Pairs of a bead and its
/// own periodic image are included.
std::vector<BeadPair> overlapping_pairs(const std::vector<PlacedBead>& beads,
                                        const std::optional<Box>& domain, std::size_t max_pairs);

/// Returns the smallest distance between two surfaces of beads, their periodic images and walls [length].
/// Negative if surfaces overlap.
double smallest_gap(const std::vector<PlacedBead>& beads, const std::optional<Box>& domain);

}  // namespace beadswim
