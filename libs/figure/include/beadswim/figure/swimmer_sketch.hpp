#pragma once

#include <array>
#include <string>
#include <vector>

#include "beadswim/figure/drawing.hpp"

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

/// Draws beads, springs and dashpots, with forces above the beads and lengths below them. The numbers are the
/// beads: number, distance of the centre from that of bead 1, and radius, with the unit of length.
Drawing draw(const SwimmerSketch& sketch);

}  // namespace beadswim
