#pragma once

#include "beadswim/lattice/populations.hpp"
#include "beadswim/lattice/trt.hpp"

namespace beadswim {

/// Sets the populations of a cell to the equilibrium at density 1 + r and velocity u (lattice units).
inline void set_equilibrium(Populations& populations, std::ptrdiff_t cell, double r, const Vec3& u) {
  for (int i = 0; i < d3q19::directions; ++i)
    populations.set_outgoing(i, cell, equilibrium(i, r, u[0], u[1], u[2]));
}

}  // namespace beadswim
