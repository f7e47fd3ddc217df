#pragma once

#include "beadswim/core/names.hpp"

namespace beadswim {

/// How fluid and beads meet: what returns to the fluid along a link that ends in a bead, or no links at all.
enum class BeadScheme {
  staircase,  ///< bounce-back half-way: the bead is a staircase of cells
  cli,        ///< central linear interpolation: the surface is where it is along each link
  mr,         ///< multireflection: the same for flows that are parabolic along the link
  psm,        ///< no links: fluid fills beads too, and partially saturated cells hold it to their motion
};

/// What users can choose and tests/verification measures.
template <>
inline constexpr auto name_table<BeadScheme> =
    std::to_array<NamedValue<BeadScheme>>({{BeadScheme::staircase, "staircase"},
                                           {BeadScheme::cli, "cli"},
                                           {BeadScheme::mr, "mr"},
                                           {BeadScheme::psm, "psm"}});

constexpr bool has_links(BeadScheme scheme) {
  return scheme != BeadScheme::psm;
}

/// How many fluid cells behind its own a link reads.
constexpr int cells_behind(BeadScheme scheme) {
  switch (scheme) {
    case BeadScheme::cli:
      return 1;
    case BeadScheme::mr:
      return 2;
    default:
      return 0;
  }
}

}  // namespace beadswim
