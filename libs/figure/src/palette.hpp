#pragma once

#include <array>
#include <cstddef>

namespace beadswim {

/// Palette of Okabe and Ito for all kinds of colour vision. Yellow is omitted because it is faint on white.
inline constexpr std::array palette{"#0072B2", "#D55E00", "#009E73", "#CC79A7",
                                    "#E69F00", "#56B4E9", "#000000"};

/// Returns the index of a colour in the palette, modulo the size of the palette.
inline constexpr std::size_t palette_place(int colour) {
  return static_cast<std::size_t>(colour) % palette.size();
}

}  // namespace beadswim
