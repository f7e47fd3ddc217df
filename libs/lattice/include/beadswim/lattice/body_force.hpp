#pragma once

#include "beadswim/core/kernel.hpp"
#include "beadswim/lattice/d3q19.hpp"

// A uniform force g per volume of fluid, which acts at the end of a time step, after the collision. It moves
// the populations by the difference of two equilibria (trt.hpp):
//
//   f_i += e_i(r, u + g) - e_i(r, u) = w_i (3 c_i.g + 9 (c_i.v)(c_i.g) - 3 v.g),   v = u + g/2
//
//   u  momentum of the cell before the force acts;  v: velocity in the middle of the step
//   g  momentum that each cell gains in one step
//
// Kupershtokh, Medvedev & Karpov, Comput. Math. Appl. 58 (2009) 965 (exact difference method).

namespace beadswim {

/// A body force in the form that add_body_force() needs.
template <class Real>
struct BodyForce {
  Real twelfth[3] = {0, 0, 0};  ///< g/12 [cell/step^2]
  bool acts = false;            ///< false if g is zero
};

/// Adds the force to the 19 populations of one cell, by the equation above. The terms that are odd in c_i add
/// the momentum without rounding, because w_i/w_diagonal = 1 or 2.
template <class Real>
BEADSWIM_KERNEL void add_body_force(Real (&f)[d3q19::directions], const BodyForce<Real>& force) {
  using namespace d3q19;
  Real density, v[3];
  moments_of(f, density, v);
#pragma GCC unroll 3
  for (int a = 0; a < 3; ++a) v[a] += 6 * force.twelfth[a];
  const Real vg = v[0] * force.twelfth[0] + v[1] * force.twelfth[1] + v[2] * force.twelfth[2];
  f[0] -= 12 * vg;
#pragma GCC unroll 10
  for (int k = 1; k <= 9; ++k) {
    Real cv = 0, cg = 0;
#pragma GCC unroll 3
    for (int a = 0; a < 3; ++a) {
      const int c = velocity[2 * k - 1][a];
      if (c == 1) cv += v[a], cg += force.twelfth[a];
      if (c == -1) cv -= v[a], cg -= force.twelfth[a];
    }
    const Real share = k <= 3 ? Real(2) : Real(1);  // 36 w_i
    const Real odd = share * cg, even = share * (3 * cv * cg - vg);
    f[2 * k - 1] += even + odd;
    f[2 * k] += even - odd;
  }
}

}  // namespace beadswim
