#pragma once

#include <cmath>
#include <complex>

#include "beadswim/mobility/line_kernel.hpp"

// clang-format off
// A rigid sphere in oscillating flow, exp(i omega t): what its size does to the flow that it makes and feels.
//
//   alpha^2 = i omega rho / eta,   kappa = alpha a,   D = 1 + kappa + kappa^2/3
//
// With fluid thought to fill the sphere, it pushes that with the force density
//
//   6 pi eta a (U - Ubar) [ (1 + kappa) delta(r - a)/(4 pi a^2) + (kappa^2/3)/(4 pi a^3/3) inside ]
//
// and follows the same mean of the flow of others (Faxen):
//
//   f = 6 pi eta a D (U - Ubar),   Ubar = [ (1 + kappa) <u>_surface + (kappa^2/3) <u>_volume ]/D
//   f = F - i omega (m - m_f) U
//   F = Z U of a lone sphere,      Z = 6 pi eta a (1 + kappa + kappa^2/9) + i omega m
//
//   a         radius [length];  U velocity of the sphere, Ubar mean of the flow u of others [length/time]
//   omega     angular frequency [1/time];  rho density [mass/length^3], eta dynamic viscosity [mass/(length time)]
//   f, F      force induced in the fluid, force from outside [mass length/time^2];  m, m_f mass, that of the fluid displaced
//
// Means over a sphere multiply helmholtz flow by sinh(kappa)/kappa (surface) or 3 (kappa cosh kappa - sinh kappa)/kappa^3
// (volume), and harmonic flow by 1. So, per unit induced force f, the flow of a sphere is that of a point with helmholtz
// times e^kappa/D, and between two spheres Ubar_i = (helmholtz e^{kappa_i + kappa_j}/(D_i D_j) + harmonic) f_j. Exact for
// the first flow of each sphere; reflections are left out. Spheres apart; |kappa| < 300, or the exponentials overflow.
// clang-format on
//
// References: Mazur and Bedeaux, Physica 76, 235 (1974); Kim and Karrila, Microhydrodynamics (1991),
// chapter 6. Page: docs/method/unsteady-stokes.md.

namespace beadswim {

/// What multiplies the helmholtz part of a flow, less 1; the harmonic part is multiplied by 1.
struct SizeFactor {
  std::complex<double> excess{};
};

inline SizeFactor operator*(const SizeFactor& a, const SizeFactor& b) {
  return {a.excess + b.excess + a.excess * b.excess};
}

/// D: the induced force of a lone moving sphere over 6 pi eta a U.
inline std::complex<double> induced_force_factor(std::complex<double> kappa) {
  return 1.0 + kappa + kappa * kappa / 3.0;
}

/// e^kappa - 1 - kappa - kappa^2/2, without cancellation.
inline std::complex<double> exponential_remainder(std::complex<double> kappa) {
  if (std::abs(kappa) > 1) return std::exp(kappa) - 1.0 - kappa - kappa * kappa / 2.0;
  std::complex<double> term = kappa * kappa / 2.0, sum = 0;
  for (int n = 3; n <= 20; ++n) sum += term *= kappa / static_cast<double>(n);  // 1/21! = 2e-20
  return sum;
}

/// e^kappa/D: of the flow that a sphere makes per unit induced force, and of the mean Ubar that it follows.
inline SizeFactor sphere_factor(std::complex<double> kappa) {
  return {(exponential_remainder(kappa) + kappa * kappa / 6.0) / induced_force_factor(kappa)};
}

/// sinh(kappa)/kappa: of the mean of another's flow over the sphere's surface.
inline SizeFactor surface_mean_factor(std::complex<double> kappa) {
  if (kappa == 0.0) return {};
  return {(exponential_remainder(kappa) - exponential_remainder(-kappa)) / (2.0 * kappa)};
}

/// helmholtz times its factor plus harmonic, without cancellation as alpha -> 0.
inline LineKernel<std::complex<double>> combined(const UnsteadyFlow& flow, const SizeFactor& factor) {
  const auto& [helmholtz, harmonic, whole] = flow;
  return {whole.value + factor.excess * helmholtz.value,
          whole.by_receiver + factor.excess * helmholtz.by_receiver,
          whole.by_source + factor.excess * helmholtz.by_source};
}

}  // namespace beadswim
