#include "beadswim/collinear/unsteady_stokes.hpp"

#include <Eigen/Core>
#include <cmath>
#include <numbers>

#include "beadswim/core/complex.hpp"

namespace beadswim {

namespace {

/// A radial function h(r) and its derivatives D h, D^2 h and D^3 h, where D = (1/r) d/dr.
using RadialDerivatives = Eigen::Array4cd;

// clang-format off
/// Evaluates h = e^{-z}/r and its derivatives, with z = alpha r and D = (1/r) d/dr:
///
///   D h = -h (1 + z)/r^2,   D^2 h = h (3 + 3 z + z^2)/r^4,   D^3 h = -h (15 + 15 z + 6 z^2 + z^3)/r^6
RadialDerivatives decaying(Complex z, double r) {
  const Complex h  = std::exp(-z) / r;
  const double  r2 = r * r;
  return { h,
          -h * ( 1.0 + z)                           /  r2,
           h * ( 3.0 + z * ( 3.0 + z))              / (r2 * r2),
          -h * (15.0 + z * (15.0 + z * (6.0 + z)))  / (r2 * r2 * r2)};
}
// clang-format on

RadialDerivatives coulomb(double r) {
  return decaying(0, r);
}

/// Evaluates the derivatives D h, D^2 h and D^3 h of h for |z| < 1, where z = alpha r, D = (1/r) d/dr and
///
///   h = (e^{-alpha r} - 1)/r = sum_{m >= 1} (-alpha)^m r^{m-1}/m!
///
/// Since D r^n = n r^{n-2}, each term is differentiated exactly. The term m = 1 is constant in space and has
/// no derivatives. h itself is set to 0, because only its derivatives are used.
RadialDerivatives decaying_less_coulomb(Complex z, double r) {
  constexpr int last = 22;  // 1/22! = 9e-22
  const double r2 = r * r;
  RadialDerivatives sum = RadialDerivatives::Zero();
  Complex power = -z / r;  // (-z)^m / (m! r)
  for (int m = 2; m <= last; ++m) {
    power *= -z / static_cast<double>(m);
    Complex term = power;
    for (int order = 1; order < 4; ++order) {
      term *= (m + 1 - 2 * order) / r2;
      sum[order] += term;
    }
  }
  return sum;
}

/// Returns the kernel d^2 h/dx^2 = D h + x^2 D^2 h. Its derivative by x is 3 x D^2 h + x^3 D^3 h.
LineKernel<Complex> second_derivative(const RadialDerivatives& h, double x) {
  return displacement_kernel(h[1] + x * x * h[2], 3 * x * h[2] + x * x * x * h[3]);
}

}  // namespace

UnsteadyFlow unsteady_stokeslet(double viscosity, Complex alpha, double x, double line_distance_squared) {
  const double r = std::hypot(x, std::sqrt(line_distance_squared));
  const Complex z = alpha * r;
  const RadialDerivatives yukawa = decaying(z, r);
  const RadialDerivatives excess = std::abs(z) < 1 ? decaying_less_coulomb(z, r) : yukawa - coulomb(r);
  const double scale = 1 / (4 * std::numbers::pi * viscosity);
  const Complex potential_scale = scale / (alpha * alpha);

  UnsteadyFlow flow;
  // The derivative of h by x is x D h, because dr/dx = x/r.
  flow.helmholtz = scale * displacement_kernel(yukawa[0], x * yukawa[1]);
  flow.total = flow.helmholtz;
  flow.helmholtz += -potential_scale * second_derivative(yukawa, x);
  flow.harmonic = potential_scale * second_derivative(coulomb(r), x);
  flow.total += -potential_scale * second_derivative(excess, x);
  return flow;
}

}  // namespace beadswim
