#pragma once

#include <cmath>
#include <numbers>

#include "beadswim/collinear/rotne_prager.hpp"

// clang-format off
// Hasimoto's splitting of the Oseen and Rotne-Prager tensors into a near part and a far part. The near part
// decays with the distance r as exp(-xi^2 r^2), so it is negligible for r > 4/xi. The far part is smooth.
// Ewald sums in a periodic box and the mesh method in open space use this splitting.
//
//   far    (I - kk/k^2)/(eta k^2) s(k) (1 - A k^2/6),   s(k) = (1 + k^2/(4 xi^2)) exp(-k^2/(4 xi^2)),   A = a_i^2 + a_j^2
//   near   full tensor minus the far part
//
//   k wavevector [1/length], I unit tensor, kk and rr dyadic products; far: Fourier transform
//
// An isotropic tensor without divergence follows from a scalar chi(r). For the Oseen term of the far part
// (A = 0), the Fourier transform of chi is -8 pi s(k)/k^4:
//
//   (I laplacian - grad grad) chi / (8 pi eta) = [ (chi'' + chi'/r) I + (chi'/r - chi'') rr/r^2 ] / (8 pi eta)
//
// With laplacian chi in place of chi, the same formula gives the Laplacian of the tensor. For the near part,
// chi' = erfc(xi r). With the functions s, g and c of r, where s = s(r) is not the s(k) above:
//
//   8 pi eta oseen     = (s - g) I + (s + g) rr/r^2
//   8 pi eta laplacian = [ c + g xi^2 (8 - 4 xi^2 r^2) ] I - [ 3 c + g xi^2 (4 - 4 xi^2 r^2) ] rr/r^2
//
//   s = erfc(xi r)/r,   g = 2 xi exp(-xi^2 r^2)/sqrt(pi),   c = (2 s + 2 g)/r^2,   y = xi^2 r^2
//
// The root of the mobility (mobility_root.hpp) needs parts that are both positive. Its far part has the form factors
// (1 - a_i^2 k^2/6) (1 - a_j^2 k^2/6), so that the near part also contains a_i^2 a_j^2/36 times the second Laplacian:
//
//   8 pi eta bilaplacian = g xi^4 [ (-56 + 88 y - 16 y^2) I + (-72 y + 16 y^2) rr/r^2 ]
//
//   xi splitting [1/length], r distance of the centres, a_i, a_j radii [length], eta dynamic viscosity [mass/(length time)]
//
// References: Hasimoto, J. Fluid Mech. 5, 317 (1959); af Klinteberg, Shamshirgar and Tornberg, Res. Math.
// Sci. 4, 1 (2017) for open space. Page: docs/method/mobility-product.md.
// clang-format on

namespace beadswim {

/// Sizes of two spheres in their mobility tensor.
struct PairSizes {
  double squares = 0;  ///< a_i^2 + a_j^2 of their radii [length^2]; 0: points
  double product = 0;  ///< a_i^2 a_j^2 [length^4] in an Ewald sum with positive parts, else 0
};

/// Mobility tensor of two spheres in its terms: `oseen` is the tensor of two point forces [time/mass],
/// `laplacian` its Laplacian [time/(mass length^2)], `bilaplacian` the Laplacian of this.
struct SplitTensor {
  PairTensor oseen, laplacian, bilaplacian{};

  /// Returns the mobility tensor of two spheres.
  PairTensor sphere_tensor(const PairSizes& sizes) const {
    const double size = sizes.squares / 6, second = sizes.product / 36;
    return {.isotropic = oseen.isotropic + size * laplacian.isotropic + second * bilaplacian.isotropic,
            .axial = oseen.axial + size * laplacian.axial + second * bilaplacian.axial};
  }
};

// clang-format off
/// Evaluates the near part of the mobility tensor of two spheres at the distance r > 0 of the centres
/// [length]. xi: splitting parameter [1/length], eta: dynamic viscosity [mass/(length time)].
inline SplitTensor near_tensor(double xi, double r, double eta) {
  const double unit = 1 / (8 * std::numbers::pi * eta);
  const double x2 = xi * xi, r2 = r * r;
  const double g = 2 * xi / std::sqrt(std::numbers::pi) * std::exp(-x2 * r2);
  const double s = std::erfc(xi * r) / r;
  const double c = (2 * s + 2 * g) / r2, y = x2 * r2;
  return {.oseen       = {unit * (s - g),
                          unit * (s + g)},
          .laplacian   = {unit * (     c + g * x2 * (8 - 4 * x2 * r2)),
                          unit * (-3 * c - g * x2 * (4 - 4 * x2 * r2))},
          .bilaplacian = {unit * g * x2 * x2 * (-56 + 88 * y - 16 * y * y),
                          unit * g * x2 * x2 * (-72 * y + 16 * y * y)}};
}
// clang-format on

/// Returns the velocity that the far part of an Ewald sum gives to a sphere per force on the same sphere
/// [time/mass]. If the far part is summed over all pairs of spheres including i = j, this value must be
/// subtracted for each sphere.
inline double far_self_mobility(double xi, const PairSizes& sizes, double viscosity) {
  const double root = std::sqrt(std::numbers::pi), x3 = xi * xi * xi;
  return (4 * xi / root - 20.0 / 9 * sizes.squares * x3 / root +
          28.0 / 9 * sizes.product * x3 * xi * xi / root) /
         (8 * std::numbers::pi * viscosity);
}

// clang-format off
/// Evaluates the kernel of the mesh in open space at the distance r of two beads, for r > 0 without the second
/// Laplacian, which open space does not need: the far part of the
/// mobility tensor without the factor exp(-share k^2/(4 xi^2)), which the Gaussian windows of the mesh apply
/// (particle_mesh.hpp). The Fourier transform of the kernel for point forces is
///
///   (I - kk/k^2)/(eta k^2) (1 + k^2/(4 xi^2)) exp(-(1 - share) k^2/(4 xi^2))
///
/// The tensor is (I laplacian - grad grad) chi/(8 pi eta). With chi_lap = laplacian chi in place of chi, the
/// same expression is its Laplacian. With E = erf(X r), G = exp(-X^2 r^2) and X^2 = xi^2/(1 - share):
///
///   chi     = r E + G/(sqrt(pi) X) - w E/r,     w = share/(2 xi^2)
///   chi_lap = 2 E/r + p G,                      p = 2 X^3/(sqrt(pi) xi^2)
///
///   E'      = 2 X G/sqrt(pi)
///   (E/r)'  = (E' - E/r)/r,   (E/r)'' = (2 E/r - 2 E')/r^2 - 2 X^2 E'
inline SplitTensor far_tensor(double xi, double share, double r, double eta) {
  const double unit = 1 / (8 * std::numbers::pi * eta);
  const double X = xi / std::sqrt(1 - share), X2 = X * X, root = std::sqrt(std::numbers::pi);
  if (r == 0) {  // average of I - kk/k^2 over all directions of k: (2/3) I
    const double oseen   =   X      / (2 * root) +          X2 * X / (4 * root * xi * xi);
    const double lap     = -(X2 * X /      root  + 6 * X2 * X2 * X / (4 * root * xi * xi));
    const double second  = 6 * std::pow(X, 5) / root + 15 * std::pow(X, 7) / (root * xi * xi);
    const double average = 2.0 / 3 / (std::numbers::pi * eta);
    return {.oseen = {average * oseen, 0}, .laplacian = {average * lap, 0}, .bilaplacian = {average * second, 0}};
  }
  struct Radial {
    double first, second;  // chi'/r and chi'' of a scalar chi
    PairTensor tensor(double factor) const { return {factor * (second + first), factor * (first - second)}; }
  };
  const double G = std::exp(-X2 * r * r), E = std::erf(X * r), r2 = r * r;
  const double slope          = 2 * X / root * G;                               // E'
  const double inverse_first  = (slope - E / r) / r2;                           // (E/r)'/r
  const double inverse_second = (2 * E / r - 2 * slope) / r2 - 2 * X2 * slope;  // (E/r)''
  const double w = share / (2 * xi * xi), p = 2 * X2 * X / (root * xi * xi);
  const Radial chi{.first  = E / r - w * inverse_first,
                   .second = slope - w * inverse_second};
  const Radial lap{.first  = 2 * inverse_first  - 2 * X2 * p * G,
                   .second = 2 * inverse_second + p * G * X2 * (4 * X2 * r2 - 2)};
  return {.oseen = chi.tensor(unit), .laplacian = lap.tensor(unit)};
}

/// Evaluates p/eta at the vector r from a point force F, divided by F.r, for the far part of the kernel of
/// far_tensor(): -chi_lap'/(8 pi eta r). Returns 0 for r = 0. The pressure of the far and the near part together
/// is F.r/(4 pi r^3).
inline double far_pressure(double xi, double share, double r, double eta) {
  if (r == 0) return 0;
  const double X = xi / std::sqrt(1 - share), X2 = X * X, root = std::sqrt(std::numbers::pi);
  const double G = std::exp(-X2 * r * r), E = std::erf(X * r);
  const double inverse_first = (2 * X / root * G - E / r) / (r * r);  // (E/r)'/r
  const double p = 2 * X2 * X / (root * xi * xi);
  return -(2 * inverse_first - 2 * X2 * p * G) / (8 * std::numbers::pi * eta);
}
// clang-format on

}  // namespace beadswim
