#pragma once

#include <Eigen/Core>
#include <Eigen/LU>
#include <cmath>
#include <complex>
#include <numbers>

#include "beadswim/theory/collinear_swimmer.hpp"
#include "beadswim/theory/stroke.hpp"

// Independent formula of second order in the amplitude: the velocity follows from the area that the arms
// enclose in a cycle. Evaluated in long double.
//
//   V = C omega d_1 d_2 sin(delta_1 - delta_2),   C = -(dw_3/dL_1 + dw_1/dL_2)/2,
//
// because bead 2 of a swimmer without total force moves by dx_2 = w_1 dL_1 - w_3 dL_2, and the integral over
// a cycle is the integral of the curl. L_1, L_2: arm lengths; w: distribution of the force on the beads of
// the rigid swimmer, a function of the arms. Derivatives are differences, w follows from Cramer's rule, and
// the linear response is solved for the bead positions. Only the description of the swimmer is shared with
// the library.

namespace beadswim::gauge {

using Real = long double;
using Complex = std::complex<Real>;
using Matrix3 = Eigen::Matrix<Real, 3, 3>;
using Vector3 = Eigen::Matrix<Real, 3, 1>;

/// Returns the mobility by equations (4.15) to (4.17) of the paper in their correct form, for arms L. `size`:
/// 1 for Rotne-Prager, 0 for Oseen.
inline Matrix3 pair_mobility(const CollinearSwimmer& s, Real L1, Real L2, Real size) {
  const Real x[3] = {-L1, 0, L2};
  Matrix3 m;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const Real r = std::abs(x[i] - x[j]), a = s.radius[i], b = s.radius[j];
      m(i, j) = i == j ? 1 / a : 3 / (2 * r) - size * (a * a + b * b) / (2 * r * r * r);
    }
  }
  return m / (6 * std::numbers::pi_v<Real> * s.viscosity);
}

/// Returns w by cofactors: the forces that move all three beads with equal velocity, divided by their sum.
inline Vector3 towing_shares(const Matrix3& m) {
  const Vector3 a = m.row(0), b = m.row(1), c = m.row(2);
  const Vector3 sum = b.cross(c) + c.cross(a) + a.cross(b);  // m^-1 (1, 1, 1) times det m
  return sum / sum.sum();
}

/// Returns a derivative by central differences of sixth order.
template <class Function>
Real derivative(const Function& f, Real step) {
  return (45 * (f(step) - f(-step)) - 9 * (f(2 * step) - f(-2 * step)) + f(3 * step) - f(-3 * step)) /
         (60 * step);
}

/// Returns C for a mobility that is given as a function of the arms. `step`: step of the differences.
template <class Mobility>
Real geometry(const CollinearSwimmer& s, const Mobility& mobility, Real step) {
  const Real l1 = s.arm[0], l2 = s.arm[1];
  const Real by_1 = derivative([&](Real h) { return towing_shares(mobility(l1 + h, l2))[2]; }, step);
  const Real by_2 = derivative([&](Real h) { return towing_shares(mobility(l1, l2 + h))[0]; }, step);
  return -(by_1 + by_2) / 2;
}

/// Returns the first-order changes of the arms, from (i omega + mu S) xi = mu F for the displacements xi of
/// the beads.
inline std::array<Complex, 2> arms(const CollinearSwimmer& s, const Matrix3& mobility) {
  const Real omega = 2 * std::numbers::pi_v<Real> / s.period;
  const Complex I(0, 1), k1(s.stiffness[0], omega * s.damping[0]), k2(s.stiffness[1], omega * s.damping[1]);
  const Complex f1 = -I * Real(s.amplitude[0]), f3 = -I * std::polar<Real>(1, s.phase) * Real(s.amplitude[1]);
  Eigen::Matrix<Complex, 3, 3> springs;
  springs << k1, -k1, 0, -k1, k1 + k2, -k2, 0, -k2, k2;
  const Eigen::Matrix<Complex, 3, 3> mu = mobility.cast<Complex>();
  Eigen::Matrix<Complex, 3, 3> system = mu * springs;
  system.diagonal().array() += I * omega;
  const Eigen::Matrix<Complex, 3, 1> forces(f1, -f1 - f3, f3);
  const Eigen::Matrix<Complex, 3, 1> xi = system.fullPivLu().solve(Eigen::Matrix<Complex, 3, 1>(mu * forces));
  return {xi[1] - xi[0], xi[2] - xi[1]};
}

struct SecondOrder {
  double velocity, geometry;
  std::array<std::complex<double>, 2> arms;
};

/// Returns V for a mobility that is given as a function of the arms.
template <class Mobility>
SecondOrder second_order(const CollinearSwimmer& s, const Mobility& mobility, Real step) {
  const Real omega = 2 * std::numbers::pi_v<Real> / s.period;
  const auto [x1, x2] = arms(s, mobility(Real(s.arm[0]), Real(s.arm[1])));
  const Real C = geometry(s, mobility, step);
  return {.velocity = static_cast<double>(C * omega * (x1 * std::conj(x2)).imag()),
          .geometry = static_cast<double>(C),
          .arms = {std::complex<double>(x1), std::complex<double>(x2)}};
}

}  // namespace beadswim::gauge
