#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "beadswim/core/cell_list.hpp"
#include "beadswim/scene/layout.hpp"

// Distances between the beads of a scene at the start. Periodic images are included. Cell lists make the cost
// proportional to the number of beads.

namespace beadswim {

/// One bead of a scene at the start.
struct PlacedBead {
  Vec3 centre;              ///< centre of the bead; may lie outside the box [length]
  double radius = 0;        ///< [length]
  std::size_t swimmer = 0;  ///< index in Layout::swimmers
  int bead = 0;             ///< number of the bead in the swimmer, from 0
};

/// Returns the beads of all swimmers, in order of the swimmers. The type of every swimmer must exist in the
/// layout.
std::vector<PlacedBead> placed_beads(const Layout& layout);

/// A pair of beads, or a bead and its own periodic image (first == second).
struct BeadPair {
  std::size_t first = 0;   ///< index in the list of beads
  std::size_t second = 0;  ///< not greater than `first`
  double distance = 0;     ///< smallest distance of the centres, periodic images included [length]
};

/// Sorts the bead centres into cells, so that all beads whose surfaces are within `max_gap` [length] of a
/// bead can be found. There must be at least one bead. The cells treat walls as periodic faces, so that a
/// search may also find beads that are farther away.
CellList bead_cells(const std::vector<PlacedBead>& beads, const std::optional<Box>& domain, double max_gap);

/// Returns the pairs of beads whose surfaces are at most `max_gap` [length] apart, in ascending order of
/// `first`, then of `second`. If there are more than `max_pairs`, it returns that many of them.
std::vector<BeadPair> close_pairs(const std::vector<PlacedBead>& beads, const std::optional<Box>& domain,
                                  double max_gap,
                                  std::size_t max_pairs = std::numeric_limits<std::size_t>::max());

/// Returns at most `max_pairs` pairs of beads whose surfaces touch or intersect. Pairs of a bead and its own
/// periodic image are included.
std::vector<BeadPair> overlapping_pairs(const std::vector<PlacedBead>& beads,
                                        const std::optional<Box>& domain, std::size_t max_pairs);

/// Returns the smallest distance between two surfaces of beads, their periodic images and walls [length].
/// Negative if surfaces overlap.
double smallest_gap(const std::vector<PlacedBead>& beads, const Domain& domain);

/// Returns the smallest height of a bead's centre above the wall, relative to the radius of the bead.
double smallest_relative_height(const std::vector<PlacedBead>& beads, const HalfSpace& half_space);

}  // namespace beadswim
