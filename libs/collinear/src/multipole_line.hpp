#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

// Spheres on a line in an axisymmetric Stokes flow: their multipoles, and the translation of the multipoles
// of one sphere to another. The flow u and the pressure p follow from two harmonic functions:
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

/// Returns the coefficients of the flow that a sphere of order L causes if it is at rest in an incoming flow:
/// A_0 .. A_L-1, B_1 .. B_L in 2L rows.
Eigen::MatrixXd response(int order, const IncomingFlow& flow);

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

/// Spheres on a line and the layout of the linear system for their multipole coefficients. The unknowns of
/// sphere i start at row start[i]. The last entry of `start` is the number of rows.
struct Line {
  std::span<const double> radius, position;  ///< [length]
  std::vector<int> order;                    ///< of the multipole series of each sphere
  std::vector<int> start;

  int size() const { return static_cast<int>(radius.size()); }
  int unknowns() const { return start.back(); }
  int unknowns(int sphere) const { return 2 * order[sphere]; }
  Pair pair(int receiver, int source) const;
};

/// Sets up spheres with the radii and the positions along the line [length]. The multipole orders follow from
/// the distances to the neighbours, by an empirical estimate for a relative error of the mobility near
/// exp(log_tolerance). Throws InputError if an order exceeds max_multipole_order.
Line make_line(std::span<const double> radii, std::span<const double> positions, double log_tolerance);

/// Returns the bispherical coordinate xi of sphere i relative to its nearest neighbour, or infinity for a
/// lone sphere. All image points of the other spheres, reflected into sphere i, lie within a_i exp(-xi) of
/// its centre, where a_i is its radius. The multipoles of sphere i therefore decay with the order n as
/// exp(-n xi).
double nearest_bispherical_coordinate(const Line& line, int i);

}  // namespace beadswim::multipole
