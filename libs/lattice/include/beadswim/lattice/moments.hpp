#pragma once

#include "beadswim/lattice/d3q19.hpp"
#include "beadswim/lattice/trt.hpp"

// Moments of the populations of one cell, always in the same order of additions.
//
//   r = sum f_i (density minus 1),   u = sum c_i f_i (momentum)

namespace beadswim {

BEADSWIM_KERNEL void moments_of(const double (&f)[d3q19::directions], double& r, double (&u)[3]) {
  r = f[0];
  u[0] = u[1] = u[2] = 0;
#pragma GCC unroll 19
  for (int i = 1; i < d3q19::directions; ++i) {
    r += f[i];
#pragma GCC unroll 3
    for (int a = 0; a < 3; ++a) {
      if (d3q19::velocity[i][a] == 1) u[a] += f[i];
      if (d3q19::velocity[i][a] == -1) u[a] -= f[i];
    }
  }
}

}  // namespace beadswim
