#pragma once

#include <Eigen/Core>

// A sphere in an axisymmetric Stokes flow, and the translation of its multipoles to another sphere on the
// axis. The flow u and the pressure p follow from two harmonic functions:
//
//   u = grad(z chi + phi) - 2 chi e_z,   p = 2 eta d chi / d z,   chi and phi harmonic
//
// Here z is measured from the centre of the sphere, and e_z is the unit vector of the axis. With the radius
// of the sphere as unit of length and the Legendre polynomials P_n of cos(theta):
//
//   own flow     chi = sum_n A_n r^-(n+1) P_n      phi = sum_n B_n r^-(n+1) P_n
//   incoming     chi = sum_n alpha_n r^n P_n       phi = sum_n beta_n r^n P_n
//
// The sphere causes the own flow. All other spheres cause the incoming flow. A sphere of order L has the
// coefficients A_0 .. A_L-1 and B_1 .. B_L. B_0 = -A_1, because the flux through its surface is zero. Each
// column of a matrix is a separate flow. Derivation: docs/method/axisymmetric-multipole.md.

namespace beadswim::multipole {

/// Coefficients of the incoming flow at a sphere of order L: alpha_0 .. alpha_L+1 and beta_0 .. beta_L.
struct IncomingFlow {
  Eigen::MatrixXd alpha;
  Eigen::MatrixXd beta;
};

/// A sphere of order L. Its own flow is stored as A_0 .. A_L-1, B_1 .. B_L in 2L rows.
class Sphere {
 public:
  explicit Sphere(int order);

  int order() const { return order_; }
  int unknowns() const { return 2 * order_; }
  /// Returns the own flow of a sphere at rest in an incoming flow.
  Eigen::MatrixXd response(const IncomingFlow& flow) const;

  /// Returns the own flow of a lone sphere that moves at unit velocity: A_0 = -3/4, B_1 = 1/4.
  Eigen::VectorXd translating_flow() const;

 private:
  int order_;
  // Factors of alpha_l-1, alpha_l+1 and beta_l in the response A_l-1, for l = 1 .. L.
  Eigen::ArrayXd alpha_below_, alpha_above_, beta_level_;
  // Factors of X_l-1 and X_l+1 in the tangential no-slip condition, where X = A + alpha.
  Eigen::ArrayXd tangential_below_, tangential_above_;
};

/// A receiver and a source sphere on their common axis.
struct Pair {
  double receiver_radius, source_radius;
  double offset;  ///< z of the receiver's centre minus z of the source's centre [length]
  int receiver_order, source_order;
};

/// Returns the matrix T with alpha = T A, for A of the source and alpha of the receiver. Rows are n = 0 ..
/// L+1 of the receiver, columns m = 0 .. L of the source. With R = |offset| and the radii a_i of the receiver
/// and a_j of the source:
///
///   T_nm = sign C(n+m, n) (a_i/R)^n (a_j/R)^(m+1),     C: binomial coefficient
///
/// The sign is (-1)^n for offset > 0 and (-1)^m for offset < 0.
Eigen::MatrixXd translation(const Pair& pair);

/// Returns the incoming flow at the receiver in 2L columns. In each column one of the 2L unknowns of the
/// source is 1 and the others are 0.
IncomingFlow unit_flows(const Pair& pair, const Eigen::MatrixXd& translation);

/// Returns the derivative, with respect to the offset, of the incoming flow at the receiver. `own_flow` is
/// the own flow of the source.
IncomingFlow flow_slopes(const Pair& pair, const Eigen::MatrixXd& translation,
                         const Eigen::MatrixXd& own_flow);

}  // namespace beadswim::multipole
