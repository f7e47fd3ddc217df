#pragma once

#include <Eigen/Core>

// One sphere in an axisymmetric Stokes flow, and the way of its multipoles to another sphere on the axis.
//
//   u = grad(z chi + phi) - 2 chi e_z,   p = 2 eta d chi / d z,   chi and phi harmonic
//
// with z from the sphere's centre. In units of its radius, with P_n Legendre polynomials of cos(theta),
//
//   own flow     chi = sum_n A_n r^-(n+1) P_n      phi = sum_n B_n r^-(n+1) P_n
//   of others    chi = sum_n alpha_n r^n P_n       phi = sum_n beta_n r^n P_n
//
// A sphere of order L has A_0 .. A_L-1 and B_1 .. B_L; B_0 = -A_1 as no fluid comes out of it. The columns of
// every matrix here are separate flows. Derivation: docs/method/axisymmetric-multipole.md.

namespace beadswim::multipole {

/// The flow of the other spheres at a sphere of order L: alpha_0 .. alpha_L+1 and beta_0 .. beta_L.
struct Incoming {
  Eigen::MatrixXd alpha;
  Eigen::MatrixXd beta;
};

/// The own flow, (A_0 .. A_L-1, B_1 .. B_L) in 2L rows, with which a sphere at rest answers.
class Sphere {
 public:
  explicit Sphere(int order);

  int order() const { return order_; }
  int unknowns() const { return 2 * order_; }
  Eigen::MatrixXd answer(const Incoming& flow) const;

  /// Own flow of the lone sphere that moves at unit velocity: A_0 = -3/4, B_1 = 1/4.
  Eigen::VectorXd moving() const;

 private:
  int order_;
  Eigen::ArrayXd alpha_below_, alpha_above_, beta_level_;  // of A_l-1, at l = 1 .. L
  Eigen::ArrayXd tangential_below_, tangential_above_;     // of X_l-1 and X_l+1 in the tangential condition
};

/// Where the flow of a source sphere is wanted: receiver and source on their common axis.
struct Pair {
  double receiver_radius, source_radius;
  double offset;  ///< receiver's centre minus source's centre, > 0 if the receiver lies ahead
  int receiver_order, source_order;
};

/// T: alpha = T A. Rows n = 0 .. L+1 of the receiver, columns m = 0 .. L of the source. With R = |offset|,
/// T_nm = (+-) C(n+m, n) (a_i/R)^n (a_j/R)^(m+1), sign (-1)^n ahead of the source and (-1)^m behind.
Eigen::MatrixXd translation(const Pair& pair);

/// What each of the source's 2L unknowns, at 1 with all others 0, sends to the receiver: 2L columns.
Incoming unit_flows(const Pair& pair, const Eigen::MatrixXd& translation);

/// What the source's own flows send to the receiver, differentiated by the offset.
Incoming flow_slopes(const Pair& pair, const Eigen::MatrixXd& translation, const Eigen::MatrixXd& own_flow);

}  // namespace beadswim::multipole
