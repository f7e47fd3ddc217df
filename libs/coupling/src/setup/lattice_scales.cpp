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
  return {.scales = {.length = cell, .time = step, .density = fluid.density},
          .relaxation_time = relaxation_time_of(nu * step / (cell * cell)),
          .steps_per_period = steps};
}

}  // namespace beadswim
