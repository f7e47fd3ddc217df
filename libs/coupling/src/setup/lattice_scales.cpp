#include "beadswim/coupling/lattice_scales.hpp"

#include <algorithm>
#include <cmath>

#include "beadswim/lattice/trt.hpp"

namespace beadswim {

LatticeChoice choose_lattice(double radius, const Resolution& resolution, const Fluid& fluid, double period) {
  const double cell = radius / resolution.cells_per_radius, nu = fluid.kinematic_viscosity;
  const double viscous_step = lattice_viscosity(resolution.relaxation_time) * cell * cell / nu;
  const long steps = std::max(1L, std::lround(period / viscous_step));
  const double step = period / static_cast<double>(steps);
  return {.scales = {.cell = cell, .step = step, .density = fluid.density},
          .relaxation_time = relaxation_time_of(nu * step / (cell * cell)),
          .steps_per_period = steps};
}

SwimmerType in_lattice_units(const SwimmerType& type, const LatticeScales& scales) {
  SwimmerType lattice = type;
  for (Bead& bead : lattice.beads) {
    bead.radius /= scales.cell;
    bead.density /= scales.density;
  }
  for (Spring& spring : lattice.springs) {
    spring.stiffness /= scales.stiffness();
    spring.rest_length /= scales.cell;
    spring.damping /= scales.damping();
  }
  lattice.angular_stiffness /= scales.energy();
  for (double& amplitude : lattice.driving.amplitude) amplitude /= scales.force();
  lattice.driving.period /= scales.step;
  return lattice;
}

}  // namespace beadswim
