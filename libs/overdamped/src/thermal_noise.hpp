#pragma once

#include "beadswim/mobility/mobility.hpp"
#include "beadswim/mobility/mobility_root.hpp"
#include "implicit_swimmer.hpp"

// Thermal noise of a time step of length h, of beads with the thermal energy kT (equation of Ito):
//
//   dx = [mu F + kT div mu] dt + (2 kT)^(1/2) B dW,   B B^T = mu(x)
//
// The velocities w = (2 kT/h)^(1/2) B z + kT div mu are added to those by forces in a step of the implicit
// midpoint rule, which gives a harmonic coordinate its exact variance for every h:
//
//   x' = x + h v,   v = mu F((x + x')/2) + w
//
// mu stays the same within the step, at a place that does not depend on z. The divergence of mu is the mean
// of random finite differences, with one normal vector W in each step:
//
//   div mu = < [mu(x + d W/2) - mu(x - d W/2)] W >/d
//
// It vanishes for Rotne-Prager tensors in open space and in periodic boxes, where it is not evaluated.
//
// References: Delong, Balboa Usabiaga and Donev, J. Chem. Phys. 140, 134110 (2014). Page:
// docs/method/thermal-noise.md.

namespace beadswim {

/// Velocities w of the beads by thermal noise in a step.
struct ThermalNoise {
  Beads velocities;
  ProductWork work{};
  double error = 0;  ///< relative, of B z
  bool is_converged = true;
};

/// Returns the noise of the step after `steps_done` steps, of beads at these positions. The random numbers
/// depend on the seed, the step and the bead. The mobility is then at other positions. Collective.
ThermalNoise thermal_noise(const StepScene& scene, Mobility& mobility, MobilityRoot& root,
                           const Beads& positions, long steps_done);

}  // namespace beadswim
