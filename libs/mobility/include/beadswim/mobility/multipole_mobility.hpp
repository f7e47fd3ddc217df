#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

// Mobility of spheres on a line in Stokes flow, to a stated precision: every multipole that matters.
//
//   v = mu F,   mu = R^-1,   d mu / d x_k = -mu (d R / d x_k) mu
//
// v, F  velocities of and forces on the spheres along their line [length/time, mass length/time^2]
// R     resistance matrix, of the no-slip flow around all spheres at once [mass/time]
//
// Each sphere's flow is a Papkovich-Neuber field of two axisymmetric multipole series, fitted to the flow of
// all others on its surface; the number of multipoles is raised until those left out do not matter.
// Unbounded fluid at rest at infinity, spheres of any radii that are apart.
// Page: docs/method/axisymmetric-multipole.md.

namespace beadswim {

/// Mobility of N spheres on a line, and how it changes with their places.
struct MultipoleMobility {
  Eigen::MatrixXd value;               ///< mu, N x N [time/mass], symmetric and positive definite
  std::vector<Eigen::MatrixXd> slope;  ///< d mu / d x_k, k = 1 to N [time/(mass length)]; their sum is 0
  int order;                           ///< largest multipole order of any sphere
};

/// Higher orders are refused. At a tolerance of 1e-12 two equal spheres then need a gap above 0.008 radii; a
/// large sphere with a small one beside it needs more, as the order is about 20 over the smaller bispherical
/// coordinate.
constexpr int largest_multipole_order = 300;

/// Radii and positions along the line [length], positions increasing; dynamic viscosity [mass/(length time)].
/// tolerance: truncation error of mu_ij over sqrt(mu_ii mu_jj), and of slopes over the largest slope.
/// Roundoff comes on top, some 1e-15 over the narrowest gap in radii, ten times that for slopes. Throws
/// InputError if spheres touch or overlap, if a radius, the viscosity or the tolerance is not above 0, or if
/// `tolerance` needs a higher order than largest_multipole_order; NotFiniteError if numbers overflow.
MultipoleMobility multipole_mobility(std::span<const double> radii, std::span<const double> positions,
                                     double viscosity, double tolerance = 1e-12);

}  // namespace beadswim
