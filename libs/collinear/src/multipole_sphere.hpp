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
// The own flow is the flow that the sphere causes. The incoming flow is the sum of the flows of all other
// spheres. A sphere of order L has the coefficients A_0 .. A_L-1 and B_1 .. B_L of its own flow. B_0 = -A_1,
// because the flux through its surface is zero. In a matrix of coefficients, each column is a separate flow.
// Derivation: docs/method/axisymmetric-multipole.md.

namespace beadswim::multipole {

/// Coefficients of the incoming flow at a sphere of order L: alpha_0 .. alpha_L+1 and beta_0 .. beta_L in the
/// rows. Each column is a separate flow.
struct IncomingFlow {
  Eigen::MatrixXd alpha;
  Eigen::MatrixXd beta;
};

/// Sphere whose multipole series end at the order L. The coefficients of its own flow are stored as
/// A_0 .. A_L-1, B_1 .. B_L in 2L rows.
class Sphere {
 public:
  explicit Sphere(int order);

  int order() const { return order_; }
  int unknowns() const { return 2 * order_; }
  /// Returns the coefficients of the flow that the sphere causes if it is at rest in an incoming flow.
  Eigen::MatrixXd response(const IncomingFlow& flow) const;

  /// Returns the coefficients of the flow of a lone sphere that moves at unit velocity: A_0 = -3/4,
  /// B_1 = 1/4. All other coefficients are 0.
  Eigen::VectorXd translating_flow() const;

 private:
  int order_;
  // Factors of alpha_l-1, alpha_l+1 and beta_l (incoming flow) in A_l-1 (own flow), for l = 1 .. L.
  Eigen::ArrayXd alpha_below_, alpha_above_, beta_level_;
  // Factors of X_l-1 and X_l+1 in the tangential no-slip condition, where X = A + alpha (own and incoming).
  Eigen::ArrayXd tangential_below_, tangential_above_;
};

/// Two spheres on their common axis z: the source causes a flow to which the receiver is exposed. Radii in
/// [length]; orders of their multipole series.
struct Pair {
  double receiver_radius, source_radius;
  double offset;  ///< z of the receiver's centre minus z of the source's centre [length]
  int receiver_order, source_order;
};

/// Returns the translation matrix T: a harmonic function that has the coefficients A_m of an own flow about
/// the centre of the source has the coefficients alpha_n of an incoming flow about the centre of the
/// receiver, with alpha_n = sum_m T_nm A_m. Rows are n = 0 .. receiver_order + 1, columns m = 0 ..
/// source_order. With R = |offset| and the radii a_i of the receiver and a_j of the source:
///
///   T_nm = sign C(n+m, n) (a_i/R)^n (a_j/R)^(m+1),     C: binomial coefficient
///
/// The sign is (-1)^n for offset > 0 and (-1)^m for offset < 0.
Eigen::MatrixXd translation(const Pair& pair);

/// Returns the incoming flow at the receiver per coefficient of the source's own flow. In each of the 2L
/// columns, one of the 2L coefficients of a source of order L is 1 and the others are 0. `translation` is the
/// matrix T of translation().
IncomingFlow unit_flows(const Pair& pair, const Eigen::MatrixXd& translation);

/// Returns the derivative of the incoming flow at the receiver by the offset of the centres (Pair::offset).
/// `own_flow` contains the coefficients of the flow of the source, `translation` is the matrix T of
/// translation().
IncomingFlow flow_slopes(const Pair& pair, const Eigen::MatrixXd& translation,
                         const Eigen::MatrixXd& own_flow);

}  // namespace beadswim::multipole
