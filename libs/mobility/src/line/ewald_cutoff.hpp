#pragma once

// Where Ewald's sums are cut: Gaussian factors below exp(-6.3^2) = 6e-18 are left out.

namespace beadswim {

constexpr double gaussian_reach = 6.3;

inline double longest_wave(double splitting) {
  return 2 * gaussian_reach * splitting;
}
inline double image_reach(double splitting) {
  return gaussian_reach / splitting;
}

}  // namespace beadswim
