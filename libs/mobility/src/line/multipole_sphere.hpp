#pragma once

#include <Eigen/Core>

// A sphere in an axisymmetric Stokes flow, and the translation of its multipoles to another sphere on the
// axis.
//
//   u = grad(z chi + phi) - 2 chi e_z,   p = 2 eta d chi / d z,   chi and phi harmonic
//
// where z is measured from the centre of the sphere. In units of its radius, with Legendre polynomials P_n of
// cos(theta):
//
//   own flow     chi = sum_n A_n r^-(n+1) P_n      phi = sum_n B_n r^-(n+1) P_n
//   incoming     chi = sum_n alpha_n r^n P_n       phi = sum_n beta_n r^n P_n
//
// The own flow is that of the sphere, the incoming flow that of all other spheres. A sphere of order L has
// A_0 .. A_L-1 and B_1 .. B_L. B_0 = -A_1, since the flux through its surface is zero. Each column of a
// matrix is a separate flow. Derivation: docs/method/axisymmetric-multipole.md.

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
  Eigen::ArrayXd alpha_below_, alpha_above_, beta_level_;  // coefficients of A_l-1, l = 1 .. L
  Eigen::ArrayXd tangential_below_,
      tangential_above_;  // coefficients of X_l-1, X_l+1 in the tangential condition
};

/// A receiver and a source sphere on their common axis.
struct Pair {
  double receiver_radius, source_radius;
  double
      offset;  ///< centre of the receiver minus centre of the source; > 0 if the receiver is ahead [length]
  int receiver_order, source_order;
};

/// Returns T with alpha = T A. Rows are n = 0 .. L+1 of the receiver, columns m = 0 .. L of the source. With
/// R = |offset|, T_nm = (+-) C(n+m, n) (a_i/R)^n (a_j/R)^(m+1). The sign is (-1)^n ahead of the source,
/// (-1)^m behind.
Eigen::MatrixXd translation(const Pair& pair);

/// Returns the incoming flow at the receiver for each of the source's 2L unknowns at 1 and all others at 0:
/// 2L columns.
IncomingFlow unit_flows(const Pair& pair, const Eigen::MatrixXd& translation);

/// Returns the derivative, by the offset, of the incoming flow that the source's own flows cause at the
/// receiver.
IncomingFlow flow_slopes(const Pair& pair, const Eigen::MatrixXd& translation,
                         const Eigen::MatrixXd& own_flow);

}  // namespace beadswim::multipole
