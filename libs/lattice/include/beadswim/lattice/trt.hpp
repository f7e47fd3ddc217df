#pragma once

#include "beadswim/lattice/d3q19.hpp"

// Two-relaxation-time collision with the incompressible equilibrium.
//
//   f_i* = f_i - w+ (f_i+ - e_i+) - w- (f_i- - e_i-),     f_i+- = (f_i +- f_ibar)/2
//   e_i+ = w_i (r + 9/2 (c_i.u)^2 - 3/2 u^2),             e_i-  = 3 w_i c_i.u
//   r = sum f_i (density minus 1),   u = sum c_i f_i      (momentum; the mean density is 1)
//
// f_i is the deviation of the population from w_i, which keeps digits at low speed. w+ = 1/tau sets the
// kinematic viscosity nu = (tau - 1/2)/3; w- = 8 (2 - w+)/(8 - w+) makes the product
// (1/w+ - 1/2)(1/w- - 1/2) = 3/16, for which a straight bounce-back wall sits half-way between cells, at
// every viscosity.
//
// Ginzburg, Verhaeghe & d'Humieres, Commun. Comput. Phys. 3 (2008) 427; incompressible equilibrium: He & Luo,
// J. Stat. Phys. 88 (1997) 927. Holds for |u| << c_s = 0.577 (error u^2).

namespace beadswim {

struct RelaxationRates {
  double symmetric = 0;      ///< w+
  double antisymmetric = 0;  ///< w-
};

constexpr RelaxationRates relaxation_rates(double relaxation_time) {
  const double symmetric = 1 / relaxation_time;
  return {symmetric, 8 * (2 - symmetric) / (8 - symmetric)};
}

/// nu [cell^2/step]
constexpr double lattice_viscosity(double relaxation_time) {
  return (relaxation_time - 0.5) / 3;
}
constexpr double relaxation_time_of(double lattice_viscosity) {
  return 3 * lattice_viscosity + 0.5;
}

// Always inlined: one source serves builds for several instruction sets, and no copy of it may be shared.
#define BEADSWIM_KERNEL inline __attribute__((always_inline))

/// Equilibrium deviation e_i = e_i+ + e_i- at density 1 + r and velocity (ux, uy, uz).
template <class Real>
BEADSWIM_KERNEL Real equilibrium(int i, Real r, Real ux, Real uy, Real uz) {
  const auto& c = d3q19::velocity[i];
  const Real cu = Real(c[0]) * ux + Real(c[1]) * uy + Real(c[2]) * uz;
  const Real speed_squared = ux * ux + uy * uy + uz * uz;
  return Real(d3q19::weight(i)) * (r + 3 * cu + Real(4.5) * cu * cu - Real(1.5) * speed_squared);
}

/// Collides the 19 populations of one cell in place.
template <class Real>
BEADSWIM_KERNEL void collide_trt(Real (&f)[d3q19::directions], Real rate_plus, Real rate_minus) {
  using namespace d3q19;
  Real sum[10], difference[10];  // f_i + f_ibar and f_i - f_ibar of the pair k: i = 2k-1
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
  const Real isotropic = density - Real(1.5) * (u[0] * u[0] + u[1] * u[1] + u[2] * u[2]);
  f[0] -= rate_plus * (f[0] - Real(weight_rest) * isotropic);
#pragma GCC unroll 10
  for (int k = 1; k <= 9; ++k) {
    Real cu = 0;
#pragma GCC unroll 3
    for (int a = 0; a < 3; ++a) {
      const int c = velocity[2 * k - 1][a];
      if (c == 1) cu += u[a];
      if (c == -1) cu -= u[a];
    }
    const Real w = Real(weight(2 * k - 1));
    const Real plus = rate_plus * (Real(0.5) * sum[k] - w * (isotropic + Real(4.5) * cu * cu));
    const Real minus = rate_minus * (Real(0.5) * difference[k] - 3 * w * cu);
    f[2 * k - 1] -= plus + minus;
    f[2 * k] -= plus - minus;
  }
}

}  // namespace beadswim
