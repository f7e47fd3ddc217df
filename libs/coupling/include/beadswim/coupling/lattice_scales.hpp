#pragma once

#include "beadswim/scene/unit_scales.hpp"

// Units of the lattice (cell = step = mean fluid density = 1; suffix _lu).

namespace beadswim {

/// Discretisation of a scene.
struct LatticeChoice {
  UnitScales scales;           ///< cell, step and density of the fluid
  double relaxation_time = 1;  ///< tau, adapted to the time step [step]
  long steps_per_period = 0;
};

/// Returns cell, step and relaxation time for a fluid of kinematic viscosity nu:
/// - cell = radius/cells_per_radius
/// - step = nu_lu cell^2/nu with nu_lu = (tau - 1/2)/3, rounded such that `period` is an integer number of
///   steps, which is a multiple of `multiple`
/// - relaxation time: tau, adapted to the rounded step
LatticeChoice choose_lattice(double radius, const Resolution& resolution, const Fluid& fluid, double period,
                             long multiple = 1);

}  // namespace beadswim
