#pragma once

// Cutoffs of Ewald sums with the splitting parameter xi (`splitting`, [1/length]). Gaussian factors below
// exp(-6.3^2) = 6e-18 are neglected.

namespace beadswim {

constexpr double gaussian_cutoff = 6.3;

/// Returns the wavenumber up to which waves are summed [1/length].
inline double max_wavenumber(double splitting) {
  return 2 * gaussian_cutoff * splitting;
}
/// Returns the distance up to which images are summed [length].
inline double image_cutoff(double splitting) {
  return gaussian_cutoff / splitting;
}

}  // namespace beadswim
