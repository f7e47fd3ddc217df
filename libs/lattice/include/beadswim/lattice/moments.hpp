#pragma once

#include "beadswim/core/kernel.hpp"
#include "beadswim/lattice/d3q19.hpp"

// Moments of the populations of one cell. The order of the additions is fixed, so that the bits are
// reproducible.
//
//   r = sum f_i (density minus 1),   u = sum c_i f_i (momentum)
//   f_i population of direction i minus its weight w_i;  c_i velocity of direction i (d3q19.hpp)

namespace beadswim {

/// Evaluates r (density minus 1) and u (momentum) of one cell from its populations f. Value: double, or a
/// vector of doubles with one lane per cell.
template <class Value>
BEADSWIM_KERNEL void moments_of(const Value (&f)[d3q19::directions], Value& r, Value (&u)[3]) {
  r = f[0];
  u[0] = u[1] = u[2] = Value{};
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
