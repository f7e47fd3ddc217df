#pragma once

#include <complex>

namespace beadswim {

using Complex = std::complex<double>;
inline constexpr Complex i_unit{0, 1};

}  // namespace beadswim
