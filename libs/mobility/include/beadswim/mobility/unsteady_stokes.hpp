#pragma once

#include <complex>

#include "beadswim/mobility/line_kernel.hpp"

// Unsteady Stokes flow of an oscillating force exp(i omega t) along x in unbounded fluid: velocity along x.
//
//   (i omega rho - eta laplacian) u + grad p = f,      alpha^2 = i omega rho / eta,   Re alpha > 0
//
//   helmholtz = 1/(4 pi eta) [ e^{-alpha r}/r - (1/alpha^2) d^2/dx^2 (e^{-alpha r}/r) ]
//   harmonic  = 1/(4 pi eta alpha^2) d^2/dx^2 (1/r)
//   total     = helmholtz + harmonic = G_xx
//
//   rho  density [mass/length^3];  eta dynamic viscosity [mass/(length time)]
//   x    position of the receiver relative to the force, along x [length];  r distance [length]
//
// For |alpha| r < 1 the total is summed as a power series in alpha r, because its two parts nearly cancel. It
// is accurate to 13 digits at any alpha r. As alpha -> 0 it is (I + rr/r^2)_xx/(8 pi eta r) - alpha/(6 pi
// eta) + ...
//
// References: Landau and Lifshitz, Fluid Mechanics, section 24; Kim and Karrila, Microhydrodynamics (1991),
// chapter 6. Page: docs/method/unsteady-stokes.md.

namespace beadswim {

/// The two parts of the flow and their sum, as functions of the displacement along the line [time/mass].
struct UnsteadyLine {
  LineValue<std::complex<double>> helmholtz, harmonic, total;
};

/// Evaluates the flow. `viscosity` is dynamic [mass/(length time)], alpha [1/length], x [length].
/// `line_distance_squared` is the squared distance of the receiver from the line of the force [length^2]. x
/// and `line_distance_squared` must not both be 0.
UnsteadyLine unsteady_stokeslet(double viscosity, std::complex<double> alpha, double x,
                                double line_distance_squared);

}  // namespace beadswim
