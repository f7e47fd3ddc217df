#pragma once

#include <complex>
#include <numbers>

namespace beadswim {

using Complex = std::complex<double>;

/// alpha of flow that oscillates: of argument pi/4, as alpha^2 = i omega rho / eta.
inline Complex alpha_of_modulus(double modulus) {
  return std::polar(modulus, std::numbers::pi / 4);
}

}  // namespace beadswim
