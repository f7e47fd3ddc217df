#pragma once

#include <array>
#include <string>
#include <vector>

namespace beadswim {

/// How fluid and beads meet: what returns to the fluid along a link that ends in a bead, or no links at all.
enum class BeadScheme {
  staircase,  ///< bounce-back half-way: the bead is a staircase of cells
  cli,        ///< central linear interpolation: the surface is where it is along each link
  mr,         ///< multireflection: the same for flows that are parabolic along the link
  psm,        ///< no links: fluid fills beads too, and partially saturated cells hold it to their motion
};

/// All that --bead-boundary offers and tests/verification measures.
inline constexpr std::array all_bead_schemes{BeadScheme::staircase, BeadScheme::cli, BeadScheme::mr,
                                             BeadScheme::psm};

std::string name_of(BeadScheme scheme);
std::vector<std::string> bead_scheme_names();
BeadScheme bead_scheme_named(const std::string& name);  ///< Throws InputError for a name that none has.

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
