#pragma once

#include "beadswim/core/names.hpp"

namespace beadswim {

/// Scheme of the no-slip condition on beads.
enum class BeadScheme {
  staircase,  ///< half-way bounce-back on links; the surface is a staircase of cells
  cli,        ///< central linear interpolation: uses the position of the surface on each link
  mr,         ///< multireflection: exact also for flows that are parabolic along the link
  psm,        ///< partially saturated cells: no links; fluid within beads is forced to move with them
};

/// Schemes that users can choose and that tests/verification measures.
template <>
inline constexpr auto name_table<BeadScheme> =
    std::to_array<NamedValue<BeadScheme>>({{BeadScheme::staircase, "staircase"},
                                           {BeadScheme::cli, "cli"},
                                           {BeadScheme::mr, "mr"},
                                           {BeadScheme::psm, "psm"}});

/// Returns false for psm, which couples by forces in cells.
constexpr bool has_links(BeadScheme scheme) {
  return scheme != BeadScheme::psm;
}

/// Returns the number of fluid cells behind its own fluid cell that a link reads.
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
