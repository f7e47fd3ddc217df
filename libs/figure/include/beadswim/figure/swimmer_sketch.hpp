#pragma once

#include <array>
#include <string>
#include <vector>

// One swimmer as a labelled sketch, to scale: the paper's figure 1. The same sketch gives the same bytes.

namespace beadswim {

/// Seen from the side, bead 1 at the left.
struct SwimmerSketch {
  std::string title;
  std::array<double, 3> radii{};         ///< [length]
  std::array<double, 2> rest_lengths{};  ///< [length]
  std::array<std::string, 3> radius_labels{}, force_labels{};
  std::array<std::string, 2> length_labels{}, spring_labels{}, dashpot_labels{};  ///< no dashpot where empty
  double force_angle = 0;  ///< from the swimmer's axis to the forces on beads 1 and 3, counterclockwise [rad]
  std::vector<std::string> notes{};
};

/// A whole SVG document: beads, springs and dashpots, forces above them, lengths below.
std::string swimmer_sketch_to_svg(const SwimmerSketch& sketch);

}  // namespace beadswim
