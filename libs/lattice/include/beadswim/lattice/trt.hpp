#pragma once

#include <cmath>
#include <limits>

#include "beadswim/core/kernel.hpp"
#include "beadswim/lattice/d3q19.hpp"

// clang-format off
// Two-relaxation-time collision with the incompressible equilibrium.
//
//   f_i* = f_i - w+ (f_i+ - e_i+) - w- (f_i- - e_i-)
//
//   f_i+- = (f_i +- f_ibar)/2
//   e_i+  =   w_i (r + 9/2 (c_i.u)^2 - 3/2 u^2)
//   e_i-  = 3 w_i c_i.u
//
//   f_i     deviation of the population from w_i (reduces roundoff at low speed);  f_i* after the collision
//   ibar    the direction opposite to i;  w_i, c_i weight and velocity (d3q19.hpp)
//   r       = sum f_i, the density minus 1;  u = sum c_i f_i, the momentum (the mean density is 1)
//   w+, w-  rates of the symmetric and antisymmetric parts [1/step]
//
// w+ = 1/tau sets the kinematic viscosity nu = (tau - 1/2)/3 [cell^2/step], where tau is the relaxation time
// [step]. w- = 8 (2 - w+)/(8 - w+) makes the product (1/w+ - 1/2)(1/w- - 1/2) = 3/16. With this product, a
// plane bounce-back wall lies half-way between cells at any viscosity.
// clang-format on
//
// Ginzburg, Verhaeghe & d'Humieres, Commun. Comput. Phys. 3 (2008) 427; incompressible equilibrium: He & Luo,
// J. Stat. Phys. 88 (1997) 927. The collision is valid for |u| << c_s = 0.577 cells/step. The relative
// error of the velocity is of order (u/c_s)^2.

namespace beadswim {

/// Rates of the two-relaxation-time collision [1/step].
struct RelaxationRates {
  double symmetric = 0;      ///< w+
  double antisymmetric = 0;  ///< w-
};

/// Returns w+ = 1/tau and w- = 8 (2 - w+)/(8 - w+). relaxation_time: tau [step].
constexpr RelaxationRates relaxation_rates(double relaxation_time) {
  const double symmetric = 1 / relaxation_time;
  return {symmetric, 8 * (2 - symmetric) / (8 - symmetric)};
}

/// Returns nu = (tau - 1/2)/3 [cell^2/step].
constexpr double lattice_viscosity(double relaxation_time) {
  return (relaxation_time - 0.5) / 3;
}
/// Returns tau = 3 nu + 1/2 [step].
constexpr double relaxation_time_of(double lattice_viscosity) {
  return 3 * lattice_viscosity + 0.5;
}

/// Evaluates the equilibrium e_i = e_i+ + e_i- at density 1 + r and velocity (ux, uy, uz).
template <class Real>
BEADSWIM_KERNEL Real equilibrium(int i, Real r, Real ux, Real uy, Real uz) {
  const auto& c = d3q19::velocity[i];
  const Real cu = Real(c[0]) * ux + Real(c[1]) * uy + Real(c[2]) * uz;
  const Real uu = ux * ux + uy * uy + uz * uz;
  return Real(d3q19::weight(i)) * (r + 3 * cu + Real(4.5) * cu * cu - Real(1.5) * uu);
}

/// Factors w+/18 (plus_axis) and w-/6 (minus_axis) of the collision [1/step], rounded to five binary digits
/// fewer than Real has. The collision multiplies them only by small numbers such as 18 and 9/2, so that these
/// products are exact. A collision therefore conserves mass and momentum except for the rounding of the
/// populations, which has no preferred sign. Over 20,000 steps in double precision, the momentum of a test
/// flow changed by 2e-16 of its initial value. With rounded weights instead of exact products, it changed by
/// 7e-14 of its initial value. The rounding of the factors changes the relaxation rates w+ and w- by a
/// relative 2^-19 in single and 2^-48 in double precision.
template <class Real>
struct CollisionRates {
  Real plus_axis, minus_axis;
};

/// Returns x rounded to a number of binary digits.
inline double with_digits(double x, int digits) {
  int exponent = 0;
  const double mantissa = std::frexp(x, &exponent);
  return std::ldexp(std::nearbyint(std::ldexp(mantissa, digits)), exponent - digits);
}

template <class Real>
CollisionRates<Real> collision_rates(const RelaxationRates& rates) {
  constexpr int digits = std::numeric_limits<Real>::digits - 5;
  return {static_cast<Real>(with_digits(rates.symmetric / 18, digits)),
          static_cast<Real>(with_digits(rates.antisymmetric / 6, digits))};
}

/// Collides the 19 populations of one cell in place.
template <class Real>
BEADSWIM_KERNEL void collide_trt(Real (&f)[d3q19::directions], const CollisionRates<Real>& rates) {
  using namespace d3q19;
  Real sum[10], difference[10];  // f_i + f_ibar and f_i - f_ibar of pair k, with i = 2k-1
#pragma GCC unroll 10
  for (int k = 1; k <= 9; ++k) {
    sum[k] = f[2 * k - 1] + f[2 * k];
    difference[k] = f[2 * k - 1] - f[2 * k];
  }
  Real density = f[0];
  Real u[3] = {0, 0, 0};
#pragma GCC unroll 10
  for (int k = 1; k <= 9; ++k) {
    density += sum[k];
#pragma GCC unroll 3
    for (int a = 0; a < 3; ++a) {
      const int c = velocity[2 * k - 1][a];
      if (c == 1) u[a] += difference[k];
      if (c == -1) u[a] -= difference[k];
    }
  }
  // clang-format off
  const Real isotropic      = density - Real(1.5) * (u[0] * u[0] + u[1] * u[1] + u[2] * u[2]);  // r - 3/2 u^2
  f[0] -= 18 * rates.plus_axis * f[0] - 6 * rates.plus_axis * isotropic;                        // w+ (f_0 - e_0)
  const Real half_plus      = 9 * rates.plus_axis;                                              // w+/2
  const Real half_minus     = 3 * rates.minus_axis;                                             // w-/2
  const Real isotropic_axis = rates.plus_axis * isotropic;                                      // w+/18 (r - 3/2 u^2)
  // clang-format on
#pragma GCC unroll 10
  for (int k = 1; k <= 9; ++k) {
    Real cu = 0;
#pragma GCC unroll 3
    for (int a = 0; a < 3; ++a) {
      const int c = velocity[2 * k - 1][a];
      if (c == 1) cu += u[a];
      if (c == -1) cu -= u[a];
    }
    // clang-format off
    // w+ (f_i+ - e_i+) and w- (f_i- - e_i-), where w_i = share/18
    const Real share = k <= 3 ? Real(1) : Real(0.5);
    const Real plus  = half_plus  * sum[k]        - (share * isotropic_axis + Real(4.5) * share * rates.plus_axis * cu * cu);
    const Real minus = half_minus * difference[k] -  share * rates.minus_axis * cu;
    f[2 * k - 1] -= plus + minus;
    f[2 * k]     -= plus - minus;
    // clang-format on
  }
}

}  // namespace beadswim
