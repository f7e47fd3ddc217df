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

/// Names of the schemes in flags and documents.
template <>
inline constexpr auto name_table<BeadScheme> =
    std::to_array<NamedValue<BeadScheme>>({{BeadScheme::staircase, "staircase"},
                                           {BeadScheme::cli, "cli"},
                                           {BeadScheme::mr, "mr"},
                                           {BeadScheme::psm, "psm"}});

/// Returns true if the scheme reflects populations on links between fluid cells and covered cells. Returns
/// false for psm, which applies forces in cells instead.
constexpr bool has_links(BeadScheme scheme) {
  return scheme != BeadScheme::psm;
}

/// Returns the number of fluid cells that a link reads in addition to its own fluid cell. They follow this
/// cell along the link, away from the bead.
constexpr int cells_behind(BeadScheme scheme) {
  return scheme == BeadScheme::mr ? 2 : (scheme == BeadScheme::cli ? 1 : 0);
}

}  // namespace beadswim
