#pragma once

#include <array>
#include <cstddef>

namespace beadswim {

/// Okabe and Ito's palette for all kinds of colour vision, without yellow, which is faint on white.
inline constexpr std::array palette{"#0072B2", "#D55E00", "#009E73", "#CC79A7",
                                    "#E69F00", "#56B4E9", "#000000"};

/// Position in the palette; wraps round.
inline constexpr std::size_t palette_place(int colour) {
  return static_cast<std::size_t>(colour) % palette.size();
}

}  // namespace beadswim
