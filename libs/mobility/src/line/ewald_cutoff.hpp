#pragma once

// Cutoffs of Ewald sums. Gaussian factors below exp(-6.3^2) = 6e-18 are neglected.

namespace beadswim {

constexpr double gaussian_cutoff = 6.3;

/// Returns the largest wavenumber in the sum over waves [1/length].
inline double max_wavenumber(double splitting) {
  return 2 * gaussian_cutoff * splitting;
}
/// Returns the largest distance of an image [length].
inline double image_cutoff(double splitting) {
  return gaussian_cutoff / splitting;
}

}  // namespace beadswim
