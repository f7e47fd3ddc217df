#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

// Mobility of spheres on a line in Stokes flow by multipole expansion, exact to a given tolerance.
//
//   v = mu F,   mu = R^-1,   d mu / d x_k = -mu (d R / d x_k) mu
//
//   v, F  velocities of the spheres and forces on them, along their line [length/time, mass length/time^2]
//   R     resistance matrix of the no-slip flow around all spheres together [mass/time]
//
// The flow of each sphere is a Papkovich-Neuber field of two axisymmetric multipole series. On the surface of
// the sphere it satisfies no-slip together with the flow of all other spheres. The number of multipoles is
// increased until the truncation error is within the tolerance. The fluid is unbounded and at rest at
// infinity. Spheres may have any radii but must not touch. Page: docs/method/axisymmetric-multipole.md.

namespace beadswim {

/// Mobility of N spheres on a line, and its derivatives by the positions.
struct MultipoleMobility {
  Eigen::MatrixXd value;               ///< mu, N x N [time/mass], symmetric and positive definite
  std::vector<Eigen::MatrixXd> slope;  ///< d mu / d x_k, k = 1 to N [time/(mass length)]; their sum is 0
  int order;                           ///< largest multipole order of any sphere
};

/// Upper bound of the multipole order. At a tolerance of 1e-12 it limits the gap of two equal spheres to more
/// than 0.008 radii. A large sphere beside a small one needs a larger gap, since the order is about 20
/// divided by the smaller bispherical coordinate.
constexpr int max_multipole_order = 300;

/// Evaluates the mobility. Radii and positions along the line [length], positions increasing; dynamic
/// viscosity [mass/(length time)].
///
/// `tolerance` bounds the truncation error of mu_ij relative to sqrt(mu_ii mu_jj), and of the slopes relative
/// to the largest slope. Roundoff adds about 1e-15 divided by the smallest gap in radii, and ten times that
/// for slopes.
///
/// Throws InputError if spheres touch or overlap; if a radius, the viscosity or the tolerance is not
/// positive; or if the tolerance requires an order above max_multipole_order. Throws NotFiniteError if the
/// result is non-finite.
MultipoleMobility multipole_mobility(std::span<const double> radii, std::span<const double> positions,
                                     double viscosity, double tolerance = 1e-12);

}  // namespace beadswim
