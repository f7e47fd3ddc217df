#pragma once

#include <array>
#include <string>
#include <vector>

#include "beadswim/figure/note.hpp"

// Labelled sketch of one swimmer, to scale, as in figure 1 of the paper (Pickl et al. 2017). Equal sketches
// have equal bytes.

namespace beadswim {

/// Data of a sketch. The swimmer is seen from the side, with bead 1 at the left. An arm whose dashpot label
/// is empty has no dashpot.
struct SwimmerSketch {
  std::string title;
  std::array<double, 3> radii{};         ///< [length]
  std::array<double, 2> rest_lengths{};  ///< [length]
  std::array<std::string, 3> radius_labels{}, force_labels{};
  std::array<std::string, 2> length_labels{}, spring_labels{}, dashpot_labels{};
  std::string length_unit{};
  double force_angle = 0;  ///< from the swimmer's axis to the forces on beads 1 and 3, counterclockwise [rad]
  std::vector<Note> notes{};
};

/// Returns a complete SVG document with beads, springs and dashpots. Forces are drawn above the beads,
/// lengths below the beads.
std::string swimmer_sketch_to_svg(const SwimmerSketch& sketch);

/// Returns the beads as comma-separated values: number, distance of the centre from that of bead 1, and
/// radius, with the unit of length.
std::string swimmer_sketch_to_csv(const SwimmerSketch& sketch);

}  // namespace beadswim
