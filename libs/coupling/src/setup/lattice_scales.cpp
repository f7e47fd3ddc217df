#include "beadswim/coupling/lattice_scales.hpp"

#include <algorithm>
#include <cmath>

#include "beadswim/lattice/trt.hpp"

namespace beadswim {

LatticeChoice choose_lattice(double radius, const Resolution& resolution, const Fluid& fluid, double period,
                             long multiple) {
  const double cell = radius / resolution.cells_per_radius, nu = fluid.kinematic_viscosity;
  const double viscous_step = lattice_viscosity(resolution.relaxation_time) * cell * cell / nu;
  const long steps =
      multiple * std::max(1L, std::lround(period / viscous_step / static_cast<double>(multiple)));
  const double step = period / static_cast<double>(steps);
  return {.scales = {.cell = cell, .step = step, .density = fluid.density},
          .relaxation_time = relaxation_time_of(nu * step / (cell * cell)),
          .steps_per_period = steps};
}

SwimmerType in_lattice_units(const SwimmerType& type, const LatticeScales& scales) {
  SwimmerType lattice = type;
  for (BeadAtRest& bead : lattice.beads) {
    bead.radius /= scales.cell;
    bead.density /= scales.density;
    bead.at /= scales.cell;
  }
  for (Bond& bond : lattice.bonds) {
    bond.stiffness /= scales.stiffness();
    bond.rest_length /= scales.cell;
    bond.damping /= scales.damping();
  }
  for (Angle& angle : lattice.angles) angle.stiffness /= scales.energy();
  Driving& driving = lattice.driving;
  const auto divide = [](std::vector<Harmonic>& harmonics, double unit) {
    for (Harmonic& harmonic : harmonics) harmonic.amplitude /= unit;
  };
  for (ForceDrive& drive : driving.forces) {
    drive.constant /= scales.force();
    divide(drive.harmonics, scales.force());
  }
  for (BondDrive& drive : driving.bonds)
    divide(drive.harmonics, drive.quantity == BondQuantity::tension ? scales.force() : scales.cell);
  driving.period /= scales.step;
  return lattice;
}

}  // namespace beadswim
