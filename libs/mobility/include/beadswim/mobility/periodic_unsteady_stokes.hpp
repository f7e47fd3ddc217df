#pragma once

#include <complex>
#include <vector>

#include "beadswim/mobility/periodic_stokes.hpp"
#include "beadswim/mobility/unsteady_stokes.hpp"

// clang-format off
// Unsteady Stokes flow of a periodic lattice of oscillating forces along x, along x on their line. Transforms:
//
//   helmholtz  (1/eta) (1 + k_x^2/alpha^2) / (k^2 + alpha^2)    with k = 0: 1/(eta alpha^2 V), uniform flow
//   harmonic   (1/eta) ( -  k_x^2/alpha^2) /  k^2               without k = 0
//   whole      (1/eta) (1 - k_x^2/k^2)     / (k^2 + alpha^2)    with k = 0
//
// The harmonic part is the steady flow's: with n copies of the force in the cell of volume V,
//
//   eta alpha^2 harmonic = n/V - eta laplacian of the steady G_xx
//
// For the others Ewald's sum:
//
//   helmholtz  (1/eta) integral_0^oo [ e^{-alpha^2 s} g_s - (e^{-alpha^2 s}/alpha^2) d^2 g_s/dx^2 ] ds
//   whole      (1/eta) integral_0^oo [ e^{-alpha^2 s} g_s +                    q(s)  d^2 g_s/dx^2 ] ds
//
//   g_s(r) = (4 pi s)^{-3/2} exp(-r^2/4s), the heat kernel;   q(s) = (1 - e^{-alpha^2 s})/alpha^2;   tau = 1/(4 xi^2)
// clang-format on
//
// summed as waves for s > tau and as images for s < tau, there by Gauss-Legendre quadrature. No term is
// larger than the sum, so the whole keeps its digits as alpha -> 0. Where |alpha| V^{1/3} > 13 (V the box)
// the helmholtz parts of the images are summed as they stand, since they decay within the box.
//
// Page: docs/method/unsteady-stokes.md.

namespace beadswim {

class PeriodicUnsteadyStokes {
 public:
  /// alpha [1/length], not 0, |arg alpha| <= pi/4. Keeps a reference to the steady flow of the same lattice.
  PeriodicUnsteadyStokes(const PeriodicStokes& steady, std::complex<double> alpha);

  /// At a displacement that is not a multiple of the period.
  UnsteadyLine at(double displacement) const;

  /// At the source itself, without its own singular part.
  UnsteadyLine images() const;

 private:
  struct WaveSum {
    std::complex<double> helmholtz, whole;
  };
  struct Parts {
    LineValue<std::complex<double>> helmholtz, whole;
  };

  bool decays_within_the_box() const;
  LineValue<std::complex<double>> harmonic(const LineValue<double>& steady_laplacian) const;
  UnsteadyLine flow(double displacement, const LineValue<double>& steady_laplacian) const;
  Parts ewald_sum(double displacement) const;
  Parts waves(double displacement) const;
  Parts near_images(double displacement) const;
  Parts own_part_above_the_cut() const;
  LineValue<std::complex<double>> helmholtz_images(double displacement) const;

  const PeriodicStokes& steady_;
  std::complex<double> alpha_;
  std::vector<WaveSum> wave_sums_;   ///< by wavenumber n 2 pi/period along x
  std::vector<double> image_lines_;  ///< within reach of the sum in use
  double reach_ = 0;
};

}  // namespace beadswim
