#pragma once

#include "beadswim/scene/layout.hpp"
#include "beadswim/swimmers/swimmer_type.hpp"

// Between a layout's units and lattice units (cell = step = mean fluid density = 1; names end in _lu).

namespace beadswim {

struct LatticeScales {
  double cell = 1;     ///< edge of a cell [length]
  double step = 1;     ///< time step [time]
  double density = 1;  ///< of the fluid [mass/length^3]

  double velocity() const { return cell / step; }
  double mass() const { return density * cell * cell * cell; }
  double momentum() const { return mass() * velocity(); }
  double force() const { return momentum() / step; }
  double stiffness() const { return mass() / (step * step); }
  double damping() const { return mass() / step; }
  double energy() const { return mass() * velocity() * velocity(); }
};

/// How a scene is discretised.
struct LatticeChoice {
  LatticeScales scales;
  double relaxation_time = 1;  ///< as used [step]
  long steps_per_period = 0;
};

/// Cell and step for a fluid of kinematic viscosity nu: cell = radius / cells_per_radius, step = nu_lu cell^2
/// / nu with nu_lu = (tau - 1/2)/3, and then the nearest step that divides `period` into whole steps, and its
/// tau.
LatticeChoice choose_lattice(double radius, const Resolution& resolution, const Fluid& fluid, double period);

SwimmerType in_lattice_units(const SwimmerType& type, const LatticeScales& scales);

}  // namespace beadswim
