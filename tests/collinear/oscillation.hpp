#pragma once

#include <numbers>

#include "beadswim/core/complex.hpp"

namespace beadswim {

/// Returns the inverse penetration depth alpha of an oscillating flow, alpha^2 = i omega rho / eta, with this
/// modulus. The argument of alpha is therefore pi/4.
inline Complex alpha_of_modulus(double modulus) {
  return std::polar(modulus, std::numbers::pi / 4);
}

}  // namespace beadswim
