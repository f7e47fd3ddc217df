#pragma once

#include <complex>
#include <vector>

#include "beadswim/mobility/periodic_stokes.hpp"
#include "beadswim/mobility/unsteady_stokes.hpp"

// clang-format off
// Unsteady Stokes flow of a periodic lattice of oscillating forces along x: velocity along x on their line.
// Transforms:
//
//   helmholtz  (1/eta) (1 + k_x^2/alpha^2) / (k^2 + alpha^2)    with k = 0: 1/(eta alpha^2 V), uniform flow
//   harmonic   (1/eta) ( -  k_x^2/alpha^2) /  k^2               without k = 0
//   total      (1/eta) (1 - k_x^2/k^2)     / (k^2 + alpha^2)    with k = 0
//
// The harmonic part follows from the steady flow. With n copies of the force in the lattice cell of volume V,
//
//   eta alpha^2 harmonic = n/V - eta laplacian of the steady G_xx
//
// Helmholtz part and total are Ewald sums of the integrals
//
//   helmholtz  (1/eta) integral_0^oo [ e^{-alpha^2 s} g_s - (e^{-alpha^2 s}/alpha^2) d^2 g_s/dx^2 ] ds
//   total      (1/eta) integral_0^oo [ e^{-alpha^2 s} g_s +                    q(s)  d^2 g_s/dx^2 ] ds
//
//   g_s(r) = (4 pi s)^{-3/2} exp(-r^2/4s), the heat kernel;   q(s) = (1 - e^{-alpha^2 s})/alpha^2;   tau = 1/(4 xi^2)
// clang-format on
//
// For s > tau the integrals are sums over waves, for s < tau sums over images with Gauss-Legendre quadrature.
// No term is larger than the sum, so the total suffers no loss of significance as alpha -> 0. Where
// |alpha| V^{1/3} > 13 (V volume of the box), the helmholtz flows of the images decay within the box and are
// summed directly.
//
// Page: docs/method/unsteady-stokes.md.

namespace beadswim {

class PeriodicUnsteadyStokes {
 public:
  /// Requires alpha [1/length] != 0 and |arg alpha| <= pi/4. Keeps a reference to the steady flow of the
  /// lattice.
  PeriodicUnsteadyStokes(const PeriodicStokes& steady, std::complex<double> alpha);

  /// Evaluates the flow at a displacement [length] that is not a multiple of the period.
  UnsteadyLine at(double displacement) const;

  /// Evaluates the flow at the source by all its images, without the singular flow of the source itself.
  UnsteadyLine images() const;

 private:
  struct WaveSum {
    std::complex<double> helmholtz, total;
  };
  struct Parts {
    LineValue<std::complex<double>> helmholtz, total;
  };

  bool decays_within_box() const;
  LineValue<std::complex<double>> harmonic(const LineValue<double>& steady_laplacian) const;
  UnsteadyLine flow(double displacement, const LineValue<double>& steady_laplacian) const;
  Parts ewald_sum(double displacement) const;
  Parts waves(double displacement) const;
  Parts near_images(double displacement) const;
  Parts self_flow_of_waves() const;
  LineValue<std::complex<double>> helmholtz_images(double displacement) const;

  const PeriodicStokes& steady_;
  std::complex<double> alpha_;
  std::vector<WaveSum> wave_sums_;   ///< per wavenumber n 2 pi/period along x
  std::vector<double> image_lines_;  ///< squared distances within cutoff_ [length^2]
  double cutoff_ = 0;                ///< distance up to which images are summed [length]
};

}  // namespace beadswim
