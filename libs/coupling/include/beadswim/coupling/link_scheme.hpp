#pragma once

#include <string>

namespace beadswim {

/// What returns to the fluid along a link that ends in a bead.
enum class LinkScheme {
  staircase,  ///< bounce-back half-way: the bead is a staircase of cells
  cli,        ///< central linear interpolation: the surface is where it is along each link
};

std::string name_of(LinkScheme scheme);

/// Whether a link also reads the fluid cell behind its own.
constexpr bool reads_behind(LinkScheme scheme) {
  return scheme != LinkScheme::staircase;
}

}  // namespace beadswim
