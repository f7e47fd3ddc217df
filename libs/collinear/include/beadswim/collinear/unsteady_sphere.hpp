#pragma once

#include <cmath>
#include <complex>

#include "beadswim/collinear/line_kernel.hpp"

// clang-format off
// Effect of the radius of a rigid sphere in a flow that oscillates as exp(i omega t). The radius changes the
// flow that the sphere causes, and the force on the sphere in the flow u of other spheres.
//
//   alpha^2 = i omega rho / eta,   kappa = alpha a,   D = 1 + kappa + kappa^2/3
//
// The sphere can be replaced by fluid on which this force density acts:
//
//   6 pi eta a (U - Ubar) [ (1 + kappa) delta(r - a)/(4 pi a^2) + (kappa^2/3)/(4 pi a^3/3) inside ]
//
// The flow u of other spheres acts on the sphere by its average Ubar, with the weights of this force density
// (Faxen's law):
//
//   f = 6 pi eta a D (U - Ubar),   Ubar = [ (1 + kappa) <u>_surface + (kappa^2/3) <u>_volume ]/D
//   f = F - i omega (m - m_f) U
//   F = Z U of a lone sphere,      Z = 6 pi eta a (1 + kappa + kappa^2/9) + i omega m
//
//   a         radius [length];  U velocity of the sphere, Ubar mean of the flow u of others [length/time]
//   omega     angular frequency [1/time];  rho density [mass/length^3], eta dynamic viscosity [mass/(length time)]
//   f, F      force induced in the fluid, external force [mass length/time^2];  m, m_f mass of sphere, of displaced fluid
//
// The flow of a point force is the sum of a helmholtz and a harmonic part (unsteady_stokes.hpp). The average
// of the harmonic part over a sphere equals its value at the centre. The average of the helmholtz part is the
// value at the centre times sinh(kappa)/kappa (surface) or 3 (kappa cosh kappa - sinh kappa)/kappa^3
// (volume). Therefore, per unit induced force f:
//
//   flow of a sphere       helmholtz e^kappa/D + harmonic
//   between two spheres    Ubar_i = (helmholtz e^{kappa_i + kappa_j}/(D_i D_j) + harmonic) f_j
//
// The law is exact for the flow that each sphere causes directly. Flow that other spheres reflect is
// neglected. Spheres must not overlap. |kappa| must be below 300 to avoid overflow.
// clang-format on
//
// References: Mazur and Bedeaux, Physica 76, 235 (1974); Kim and Karrila, Microhydrodynamics (1991), chapter
// 6. Page: docs/method/unsteady-stokes.md.

namespace beadswim {

/// Factor by which the radii of spheres multiply the helmholtz part of a flow (unsteady_stokes.hpp), minus 1.
/// The factor of the harmonic part is always 1.
struct SizeFactor {
  std::complex<double> excess{};
};

inline SizeFactor operator*(const SizeFactor& a, const SizeFactor& b) {
  return {a.excess + b.excess + a.excess * b.excess};
}

/// Returns D = 1 + kappa + kappa^2/3 for a sphere of radius a, with kappa = alpha a and
/// alpha = sqrt(i omega rho/eta). A lone sphere of velocity U induces the force 6 pi eta a D U in the fluid.
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

/// Returns e^kappa/D, D = 1 + kappa + kappa^2/3, as a factor of the helmholtz part. The factor applies to the
/// flow that a sphere causes per unit induced force, and to the average of the flow of other spheres over the
/// sphere.
inline SizeFactor sphere_factor(std::complex<double> kappa) {
  return {(exponential_remainder(kappa) + kappa * kappa / 6.0) / induced_force_factor(kappa)};
}

/// Returns sinh(kappa)/kappa with kappa = alpha a, as a factor of the helmholtz part of the flow of another
/// sphere. It is the ratio of the average of this part over the surface of a sphere of radius a to its value
/// at the centre.
inline SizeFactor surface_mean_factor(std::complex<double> kappa) {
  if (kappa == 0.0) return {};
  return {(exponential_remainder(kappa) - exponential_remainder(-kappa)) / (2.0 * kappa)};
}

/// Returns the flow between spheres, (1 + factor.excess) helmholtz + harmonic, without loss of significance
/// as alpha -> 0.
inline LineKernel<std::complex<double>> total_flow(const UnsteadyFlow& flow, const SizeFactor& factor) {
  LineKernel<std::complex<double>> sum = flow.total;
  sum += factor.excess * flow.helmholtz;
  return sum;
}

}  // namespace beadswim
