#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

// Mobility of spheres on a line in Stokes flow by multipole expansion, with a truncation error below a given
// tolerance.
//
//   v = mu F,   mu = R^-1,   d mu / d x_k = -mu (d R / d x_k) mu
//
//   v, F  velocities of the spheres and forces on them, along their line [length/time, mass length/time^2]
//   R     resistance matrix of the no-slip flow around all spheres together [mass/time]
//
//   p = sigma . F,   p: axial stresslet of all spheres, whose flow on the axis far away is p/(4 pi eta r^2)
//
// The fluid is unbounded and at rest at infinity. Each sphere causes a Papkovich-Neuber flow, which is given
// by two axisymmetric multipole series. On the surface of each sphere, the sum of the flows of all spheres
// satisfies the no-slip condition. The number of multipoles is increased until the truncation error is within
// the tolerance. Spheres may have any radii but must not touch. Page: docs/method/axisymmetric-multipole.md.

namespace beadswim {

/// Mobility of N spheres on a line, and its derivatives by the positions x_k of the spheres.
struct MultipoleMobility {
  Eigen::MatrixXd value;               ///< mu, N x N [time/mass], symmetric and positive definite
  std::vector<Eigen::MatrixXd> slope;  ///< d mu / d x_k, k = 1 to N [time/(mass length)]; sum over k is 0
  Eigen::VectorXd stresslet;           ///< sigma [length]
  Eigen::MatrixXd stresslet_slope;     ///< column k: d sigma / d x_k [1]
  int order;                           ///< highest order in the multipole series of any sphere
};

/// Upper bound of the highest order in the multipole series of a sphere. The bound limits how small the gaps
/// may be. At a tolerance of 1e-12, two equal spheres require a gap of more than 0.008 radii. A large sphere
/// beside a small one requires a larger gap, because the highest order needed is about 20/xi, where xi is the
/// smaller of the bispherical coordinates of the two spheres.
constexpr int max_multipole_order = 300;

/// Evaluates the mobility of N spheres on a line and its derivatives by the positions. Radii and positions
/// along the line are in [length]; positions must increase. `viscosity` is dynamic [mass/(length time)].
///
/// `tolerance` bounds the truncation error of mu_ij relative to sqrt(mu_ii mu_jj), and the truncation error
/// of the slopes relative to the largest slope. Roundoff adds a relative error of about 1e-15/g to mu and of
/// about 1e-14/g to the slopes, where g is the smallest gap, divided by the radius.
///
/// Throws InputError in these cases:
///   - Spheres touch or overlap.
///   - A radius, the viscosity or the tolerance is not positive.
///   - The tolerance requires a multipole order above max_multipole_order.
/// Throws NotFiniteError if the result is non-finite.
MultipoleMobility multipole_mobility(std::span<const double> radii, std::span<const double> positions,
                                     double viscosity, double tolerance = 1e-12);

}  // namespace beadswim
