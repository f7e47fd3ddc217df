#pragma once

#include <cmath>
#include <numbers>

#include "beadswim/collinear/rotne_prager.hpp"

// clang-format off
// Approximate mobility of spheres in one time step h of a fluid with memory (fluid_memory.hpp). The factor
// 1 - phi(nu k^2 h) of each mode is replaced by k^2/(k^2 + kappa^2), with kappa^2 = (9 pi/16)/(nu h). The
// self-mobility is then right within 3 %, and exact for short steps.
//
//   self  1/(6 pi eta a) (1 - e^{-2 kappa a})/(2 kappa a)
//   pair  -(I laplacian - grad grad) b/(4 pi eta kappa^2),   b = (1 - S e^{-kappa r})/r
//   S     sinh(kappa a_i)/(kappa a_i) sinh(kappa a_j)/(kappa a_j)
//
//   a_i, a_j radii, r distance of the centres [length], kappa [1/length], eta dynamic viscosity [mass/(length time)]
//
// The implicit solver uses it to predict how velocities change with forces. It does not affect results.
// clang-format on

namespace beadswim {

/// Returns kappa [1/length] for nu h [length^2].
inline double step_wavenumber(double diffusion) {
  return std::sqrt(9 * std::numbers::pi / (16 * diffusion));
}

/// Returns the ratio of the self-mobility in a step to that in steady flow, for kappa a.
inline double step_self_ratio(double size) {
  return size < 1e-6 ? 1 : -std::expm1(-2 * size) / (2 * size);
}

/// Returns the mobility tensor of two spheres in a step. The tensor of spheres that overlap is that of steady
/// flow, multiplied by the mean ratio of their self-mobilities.
inline PairTensor step_tensor(double a_i, double a_j, double r, double eta, double kappa) {
  const double x_i = kappa * a_i, x_j = kappa * a_j;
  if (r < a_i + a_j || kappa * r < 1e-2) {
    const double ratio = std::sqrt(step_self_ratio(x_i) * step_self_ratio(x_j));
    const PairTensor steady = rotne_prager_tensor(a_i, a_j, r, eta);
    return {.isotropic = ratio * steady.isotropic, .axial = ratio * steady.axial};
  }
  const double wave = std::exp(x_i + x_j - kappa * r) * step_self_ratio(x_i) * step_self_ratio(x_j);
  const double factor = -1 / (4 * std::numbers::pi * eta * kappa * kappa);
  const double slope = (wave * (kappa * r + 1) - 1) / (r * r * r);                               // b'/r
  const double second = (2 - wave * (kappa * kappa * r * r + 2 * kappa * r + 2)) / (r * r * r);  // b''
  return {.isotropic = factor * (-wave * kappa * kappa / r - slope), .axial = factor * (slope - second)};
}

}  // namespace beadswim
