#pragma once

#include <cmath>
#include <complex>

#include "beadswim/mobility/line_kernel.hpp"

// clang-format off
// Influence of the radius of a rigid sphere on the flow that it causes and feels, oscillating as exp(i omega
// t).
//
//   alpha^2 = i omega rho / eta,   kappa = alpha a,   D = 1 + kappa + kappa^2/3
//
// If the sphere is replaced by fluid, the force density that represents it is
//
//   6 pi eta a (U - Ubar) [ (1 + kappa) delta(r - a)/(4 pi a^2) + (kappa^2/3)/(4 pi a^3/3) inside ]
//
// The sphere feels the same average of the flow of other spheres (Faxen's law):
//
//   f = 6 pi eta a D (U - Ubar),   Ubar = [ (1 + kappa) <u>_surface + (kappa^2/3) <u>_volume ]/D
//   f = F - i omega (m - m_f) U
//   F = Z U of a lone sphere,      Z = 6 pi eta a (1 + kappa + kappa^2/9) + i omega m
//
//   a         radius [length];  U velocity of the sphere, Ubar mean of the flow u of others [length/time]
//   omega     angular frequency [1/time];  rho density [mass/length^3], eta dynamic viscosity [mass/(length time)]
//   f, F      force induced in the fluid, external force [mass length/time^2];  m, m_f mass of sphere, of displaced fluid
//
// Averages over a sphere multiply the helmholtz flow by sinh(kappa)/kappa (surface) or 3 (kappa cosh kappa -
// sinh kappa)/kappa^3 (volume), and the harmonic flow by 1. Therefore, per unit induced force f,
//
//   flow of a sphere       helmholtz e^kappa/D + harmonic
//   between two spheres    Ubar_i = (helmholtz e^{kappa_i + kappa_j}/(D_i D_j) + harmonic) f_j
//
// where helmholtz and harmonic are the flow of a point force. The law is exact for the first flow of each
// sphere; reflections between spheres are neglected. Spheres must not overlap. |kappa| must be below 300 to
// avoid overflow.
// clang-format on
//
// References: Mazur and Bedeaux, Physica 76, 235 (1974); Kim and Karrila, Microhydrodynamics (1991), chapter
// 6. Page: docs/method/unsteady-stokes.md.

namespace beadswim {

/// Factor of the helmholtz part of a flow, minus 1. The factor of the harmonic part is 1.
struct SizeFactor {
  std::complex<double> excess{};
};

inline SizeFactor operator*(const SizeFactor& a, const SizeFactor& b) {
  return {a.excess + b.excess + a.excess * b.excess};
}

/// Returns D, the induced force of a lone moving sphere divided by 6 pi eta a U.
inline std::complex<double> induced_force_factor(std::complex<double> kappa) {
  return 1.0 + kappa + kappa * kappa / 3.0;
}

/// Evaluates e^kappa - 1 - kappa - kappa^2/2 without loss of significance.
inline std::complex<double> exponential_remainder(std::complex<double> kappa) {
  if (std::abs(kappa) > 1) return std::exp(kappa) - 1.0 - kappa - kappa * kappa / 2.0;
  std::complex<double> term = kappa * kappa / 2.0, sum = 0;
  for (int n = 3; n <= 20; ++n) sum += term *= kappa / static_cast<double>(n);  // 1/21! = 2e-20
  return sum;
}

/// Returns e^kappa/D, the factor of the flow per unit induced force and of the average Ubar that the sphere
/// feels.
inline SizeFactor sphere_factor(std::complex<double> kappa) {
  return {(exponential_remainder(kappa) + kappa * kappa / 6.0) / induced_force_factor(kappa)};
}

/// Returns sinh(kappa)/kappa, the factor of the average of another sphere's flow over the surface.
inline SizeFactor surface_mean_factor(std::complex<double> kappa) {
  if (kappa == 0.0) return {};
  return {(exponential_remainder(kappa) - exponential_remainder(-kappa)) / (2.0 * kappa)};
}

/// Returns factor * helmholtz + harmonic, without loss of significance as alpha -> 0.
inline LineKernel<std::complex<double>> total_flow(const UnsteadyFlow& flow, const SizeFactor& factor) {
  const auto& [helmholtz, harmonic, total] = flow;
  return {.value = total.value + factor.excess * helmholtz.value,
          .by_receiver = total.by_receiver + factor.excess * helmholtz.by_receiver,
          .by_source = total.by_source + factor.excess * helmholtz.by_source};
}

}  // namespace beadswim
