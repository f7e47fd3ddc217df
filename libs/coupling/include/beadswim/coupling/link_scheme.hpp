#pragma once

#include <string>

namespace beadswim {

/// What returns to the fluid along a link that ends in a bead.
enum class LinkScheme {
  staircase,  ///< bounce-back half-way: the bead is a staircase of cells
  cli,        ///< central linear interpolation: the surface is where it is along each link
  mr,         ///< multireflection: the same for flows that are parabolic along the link
};

std::string name_of(LinkScheme scheme);

/// How many fluid cells behind its own a link reads.
constexpr int cells_behind(LinkScheme scheme) {
  return scheme == LinkScheme::staircase ? 0 : (scheme == LinkScheme::cli ? 1 : 2);
}

}  // namespace beadswim
