#pragma once

#include <array>
#include <vector>

#include "beadswim/collinear/rotne_prager.hpp"
#include "split_polynomials.hpp"

// clang-format off
// Splitting of the Oseen and Rotne-Prager tensors into a near part, which is 0 beyond the cutoff c, and a far part,
// which is smooth. Ewald sums in a periodic box and the mesh method in open space use this splitting.
//
//   far    (I - kk/k^2)/(eta k^2) s(k) (1 - A k^2/6),   A = a_i^2 + a_j^2
//   near   full tensor minus the far part
//
//   k wavevector [1/length], I unit tensor, kk and rr dyadic products; far: Fourier transform
//
// An isotropic tensor without divergence follows from a scalar chi(r). For the Oseen term of the far part (A = 0),
// the Fourier transform of chi is -8 pi s(k)/k^4:
//
//   (I laplacian - grad grad) chi / (8 pi eta) = [ laplacian chi - chi'/r ] I/(8 pi eta) + [ chi'/r - chi'' ] rr/r^2/(8 pi eta)
//
// With laplacian chi in place of chi, the same formula gives the Laplacian of the tensor. An even function phi,
// which is 0 beyond the cutoff and has the integral 1 over r > 0, determines the splitting:
//
//   far    chi' = Phi(r) = integral of phi from 0 to r,   near   chi' = 1 - Phi(r)
//   s(k) = (f - k f'/2)/2,   f(k) = 2 integral of phi cos(kr) over r > 0
//
// phi is the Kaiser-Bessel function of the shape b:
//
//   phi(r) = b/(c sinh b) I_0(b sqrt(w)),   w = 1 - r^2/c^2
//   f(k)   = 2 S(y)/S(b^2),   S(y) = sinh(sqrt y)/sqrt y,   y = b^2 - c^2 k^2
//   s(k)   = (S + c^2 k^2 S')/S(b^2)
//
// s decreases from 1 to about exp(-b) at k = b/c. All radial functions follow from phi by the operator
// d = -(1/r) d/dr = (2/c^2) d/dw:
//
//   D_n = d^n phi = b/(c sinh b) (b^2/c^2)^n I_n(z)/z^n,   z = b sqrt(w)
//   A_n = d^n Phi/r,   B_n = d^n (1 - Phi)/r,   B_(n+1) = [ (2 n + 1) B_n + D_n ]/r^2
//   near   d^n chi'/r = B_n,   d^n laplacian chi =  2 B_n - D_n,   d^n second laplacian =  (5 + 2 n) D_(n+1) - r^2 D_(n+2)
//   far    d^n chi'/r = A_n,   d^n laplacian chi =  2 A_n + D_n,   d^n second laplacian = -(5 + 2 n) D_(n+1) + r^2 D_(n+2)
//
// The root of the mobility (mobility_root.hpp) needs parts that are both positive. Its far part has the form factors
// (1 - a_i^2 k^2/6) (1 - a_j^2 k^2/6), so that the near part also contains a_i^2 a_j^2/36 times the second Laplacian.
//
//   r distance of the centres, a_i, a_j radii [length], eta dynamic viscosity [mass/(length time)]
//
// References: Hasimoto, J. Fluid Mech. 5, 317 (1959); Kaiser and Schafer, IEEE Trans. Acoust. 28, 105 (1980) (Kaiser-Bessel
// functions); Liang et al., arXiv:2505.09727 (prolate functions, whose errors are equal within 23 %).
// Page: docs/method/mobility-product.md.
// clang-format on

namespace beadswim {

/// S(y) = sinh(sqrt y)/sqrt y; for y < 0 sin(sqrt -y)/sqrt -y.
double sinh_ratio(double y);
/// S'(y).
double sinh_ratio_slope(double y);

/// I_0(shape sqrt(1 - x^2)), -1 <= x <= 1.
double kaiser_bessel_bell(double shape, double x);

struct EwaldSplit {
  double cutoff = 0, shape = 0;   ///< c [length], b
  SplitPolynomials near;          ///< of the near part
  std::vector<double> far_terms;  ///< coefficients of s by powers of y

  EwaldSplit(double cutoff, double shape);

  /// Returns s(k).
  double far_share(double k) const;
  /// Returns A_n at the distance r up to the cutoff.
  double mean(int n, double r) const;
  /// Returns D_n at the distance r up to the cutoff.
  double bell(int n, double r) const;
  /// Returns the integrals of k^(2 n) s(k) over k > 0: pi (2 n - 1)!! (2 n + 3)/4 D_n(0), n = 0 to 3.
  std::array<double, 4> far_integrals() const;
};

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

/// Returns the near part at the distance r > 0 [length]. eta: dynamic viscosity [mass/(length time)].
SplitTensor near_tensor(const EwaldSplit& split, double r, double eta);
/// Returns the far part at the distance r >= 0.
SplitTensor far_tensor(const EwaldSplit& split, double r, double eta);

/// Returns p/eta at the vector r from a point force F, divided by F.r, for the far part; 0 for r = 0. The
/// pressure of the far and the near part together is F.r/(4 pi r^3).
double far_pressure(const EwaldSplit& split, double r, double eta);

}  // namespace beadswim
