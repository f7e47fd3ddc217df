#pragma once

#include "beadswim/scene/layout.hpp"
#include "beadswim/swimmers/swimmer_type.hpp"

// Conversion between the units of a layout and lattice units (cell = step = mean fluid density = 1; suffix
// _lu).

namespace beadswim {

/// Units of the lattice in the units of the layout.
struct LatticeScales {
  double cell = 1;     ///< edge of a cell [length]
  double step = 1;     ///< time step [time]
  double density = 1;  ///< density of the fluid [mass/length^3]

  double velocity() const { return cell / step; }
  double mass() const { return density * cell * cell * cell; }
  double momentum() const { return mass() * velocity(); }
  double force() const { return momentum() / step; }
  double body_force() const { return force() / (cell * cell * cell); }
  double stiffness() const { return mass() / (step * step); }
  double damping() const { return mass() / step; }
  double energy() const { return mass() * velocity() * velocity(); }
};

/// Discretisation of a scene.
struct LatticeChoice {
  LatticeScales scales;
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

/// Converts a swimmer type from the units of the layout to lattice units.
SwimmerType in_lattice_units(const SwimmerType& type, const LatticeScales& scales);

}  // namespace beadswim
