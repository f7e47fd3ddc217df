#pragma once

#include <complex>

#include "beadswim/collinear/line_kernel.hpp"

// Unsteady Stokes flow of a point force along x in unbounded fluid. The force oscillates as exp(i omega t).
// The velocity along x per force is G_xx, the sum of a helmholtz and a harmonic part.
//
//   (i omega rho - eta laplacian) u + grad p = f,      alpha^2 = i omega rho / eta,   Re alpha > 0
//
//   helmholtz = 1/(4 pi eta) [ e^{-alpha r}/r - (1/alpha^2) d^2/dx^2 (e^{-alpha r}/r) ]
//   harmonic  = 1/(4 pi eta alpha^2) d^2/dx^2 (1/r)
//   total     = helmholtz + harmonic = G_xx
//
//   u    velocity, p pressure, f force density
//   rho  density [mass/length^3];  eta dynamic viscosity [mass/(length time)]
//   x    position of the receiver relative to the force, along x [length];  r distance [length]
//
// For |alpha| r < 1 the total is summed as a power series in alpha r, because its two parts nearly cancel.
// The total has a relative error of about 1e-13 at any alpha r. Its expansion for small alpha is
//
//   (I + rr/r^2)_xx/(8 pi eta r) - alpha/(6 pi eta) + ...
//
// References: Landau and Lifshitz, Fluid Mechanics, section 24; Kim and Karrila, Microhydrodynamics (1991),
// chapter 6. Page: docs/method/unsteady-stokes.md.

namespace beadswim {

/// Evaluates the unsteady Stokes flow of a point force along x: complex amplitude of the velocity along x per
/// force. `viscosity` is the dynamic viscosity eta [mass/(length time)], alpha = sqrt(i omega rho/eta)
/// [1/length]. x is the position of the receiver relative to the force [length]. `line_distance_squared` is
/// the squared distance of the receiver from the line along x through the force [length^2]. x and
/// `line_distance_squared` must not both be 0.
UnsteadyFlow unsteady_stokeslet(double viscosity, std::complex<double> alpha, double x,
                                double line_distance_squared);

}  // namespace beadswim
