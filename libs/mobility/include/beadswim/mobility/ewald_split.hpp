#pragma once

#include <cmath>
#include <numbers>

#include "beadswim/mobility/rotne_prager_tensor.hpp"

// clang-format off
// Hasimoto's splitting of the Oseen and Rotne-Prager tensors into a near part, gone beyond some 4/xi, and a far part that
// is smooth, as the sum of images in a periodic box and as the work between particles and mesh need it.
//
//   far    (I - kk/k^2)/(eta k^2) s(k) (1 - A k^2/6),   s(k) = (1 + k^2/(4 xi^2)) exp(-k^2/(4 xi^2)),   A = a_i^2 + a_j^2
//   near   what is left
//
// Isotropic tensors without divergence come of a scalar chi(r), of transform -8 pi s(k)/k^4 for the Oseen part:
//
//   (I laplacian - grad grad) chi / (8 pi eta) = [ (chi'' + chi'/r) I + (chi'/r - chi'') rr/r^2 ] / (8 pi eta)
//
// and the laplacian of the tensor of psi = laplacian chi. Near: chi' = erfc(xi r), for r itself without splitting.
//
// References: Hasimoto, J. Fluid Mech. 5, 317 (1959); af Klinteberg, Shamshirgar and Tornberg, Res. Math. Sci. 4, 1 (2017)
// for open space. Page: docs/method/mobility-product.md.
// clang-format on

namespace beadswim {

/// A pair tensor in parts: spheres of radii a_i, a_j have oseen + (a_i^2 + a_j^2)/6 laplacian.
struct SplitTensor {
  PairTensor oseen, laplacian;

  PairTensor of_spheres(double squared_radii) const {
    const double size = squared_radii / 6;
    return {.isotropic = oseen.isotropic + size * laplacian.isotropic,
            .axial = oseen.axial + size * laplacian.axial};
  }
};

/// The near part at r > 0; xi: splitting [1/length].
inline SplitTensor near_tensor(double xi, double r, double viscosity) {
  const double unit = 1 / (8 * std::numbers::pi * viscosity);
  const double x2 = xi * xi, r2 = r * r;
  const double gauss = 2 * xi / std::sqrt(std::numbers::pi) * std::exp(-x2 * r2);
  const double screened = std::erfc(xi * r) / r;
  const double cube = (2 * screened + 2 * gauss) / r2;  // 2 erfc/r^3 + 4 xi/(sqrt(pi) r^2) exp(-xi^2 r^2)
  return {.oseen = {unit * (screened - gauss), unit * (screened + gauss)},
          .laplacian = {unit * (cube + gauss * x2 * (8 - 4 * x2 * r2)),
                        unit * (-3 * cube - gauss * x2 * (4 - 4 * x2 * r2))}};
}

/// What the far part does to a sphere by its own force: to be taken off where the far part is summed over all
/// pairs.
inline double far_self_mobility(double xi, double squared_radius, double viscosity) {
  const double root = std::sqrt(std::numbers::pi);
  return (4 * xi / root - 40.0 / 9 * squared_radius * xi * xi * xi / root) /
         (8 * std::numbers::pi * viscosity);
}

/// (1 + k^2/(4 xi^2)) exp(-exponent)/(eta k^2), k > 0. `exponent`: what windows leave of the far part's
/// Gaussian, k^2/(4 xi^2) where there are none.
inline double far_spectrum(double xi, double k2, double exponent, double viscosity) {
  return (1 + k2 / (4 * xi * xi)) * std::exp(-exponent) / (viscosity * k2);
}

/// The far part in open space when windows take the share `share` of its Gaussian: transform
/// (I - kk/k^2)/(eta k^2) (1 + k^2/(4 xi^2)) exp(-(1 - share) k^2/(4 xi^2)). With xi'^2 = xi^2/(1 - share):
///   chi     = r erf(xi' r) + exp(-xi'^2 r^2)/(sqrt(pi) xi') - share/(2 xi^2) erf(xi' r)/r
///   chi_lap = 2 erf(xi' r)/r + 2 xi'^3/(sqrt(pi) xi^2) exp(-xi'^2 r^2)
inline SplitTensor far_tensor(double xi, double share, double r, double viscosity) {
  const double unit = 1 / (8 * std::numbers::pi * viscosity);
  const double own = xi / std::sqrt(1 - share), own2 = own * own, root = std::sqrt(std::numbers::pi);
  if (r == 0) {  // (2/3) of the integral of the transform over all k
    const double zero = own / (2 * root) + own2 * own / (4 * root * xi * xi);
    const double lap = -(own2 * own / root + 6 * own2 * own2 * own / (4 * root * xi * xi));
    const double average = 2.0 / 3 / (std::numbers::pi * viscosity);
    return {.oseen = {average * zero, 0}, .laplacian = {average * lap, 0}};
  }
  struct Radial {  // chi'/r and chi'' of a scalar
    double first, second;
    PairTensor tensor(double factor) const { return {factor * (second + first), factor * (first - second)}; }
  };
  const double gauss = std::exp(-own2 * r * r), erf = std::erf(own * r), r2 = r * r;
  const double slope = 2 * own / root * gauss;          // of erf(xi' r)
  const double inverse_first = (slope - erf / r) / r2;  // of erf(xi' r)/r
  const double inverse_second = (2 * erf / r - 2 * slope) / r2 - 2 * own2 * slope;
  const double weight = share / (2 * xi * xi), peak = 2 * own2 * own / (root * xi * xi);
  const Radial chi{erf / r - weight * inverse_first, slope - weight * inverse_second};
  const Radial lap{2 * inverse_first - 2 * own2 * peak * gauss,
                   2 * inverse_second + peak * gauss * own2 * (4 * own2 * r2 - 2)};
  return {.oseen = chi.tensor(unit), .laplacian = lap.tensor(unit)};
}

}  // namespace beadswim
