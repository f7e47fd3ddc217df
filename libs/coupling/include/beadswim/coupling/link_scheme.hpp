#pragma once

#include <string>

namespace beadswim {

/// How fluid and beads meet: what returns to the fluid along a link that ends in a bead, or no links at all.
enum class LinkScheme {
  staircase,  ///< bounce-back half-way: the bead is a staircase of cells
  cli,        ///< central linear interpolation: the surface is where it is along each link
  psm,        ///< no links: fluid fills beads too, and partially saturated cells hold it to their motion
};

std::string name_of(LinkScheme scheme);

constexpr bool has_links(LinkScheme scheme) {
  return scheme != LinkScheme::psm;
}

/// Whether a link also reads the fluid cell behind its own.
constexpr bool reads_behind(LinkScheme scheme) {
  return has_links(scheme) && scheme != LinkScheme::staircase;
}

}  // namespace beadswim
