#pragma once

#include "beadswim/coupling/bead_scheme.hpp"
#include "beadswim/swimmers/swimmer_type.hpp"

// Corrections of the radius and of the density of beads on the lattice.
//
// Hydrodynamic radius of a bead: the radius of the sphere whose exact drag in slow flow equals the drag of
// the bead. It was measured for fixed spheres in a cubic array and averaged over positions within a cell. It
// depends on the scheme and on the radius in cells, but not on the relaxation time (docs/verification.md).
//
// The force of the fluid on a bead lags by a time t_d, which is the same for every bead:
//
//   F(t) = -zeta u(t - t_d) = -zeta u + zeta t_d du/dt + O(omega^2 t_d^2),     zeta = 6 pi eta R
//
// F: force; u: velocity of the bead; R: radius; eta: dynamic viscosity; omega: angular frequency. A bead of
// mass m moves like a bead of mass m - zeta t_d without delay. If the mass is increased by zeta t_d, the bead
// moves correctly, and momentum is still conserved. The moment of inertia increases in proportion, which
// compensates 0.3 to 0.45 of the delay of the torque. See docs/method/force-delay.md.

namespace beadswim {

/// Returns the radius on the lattice for which the hydrodynamic radius of a bead equals `radius` [cell].
double corrected_radius(BeadScheme scheme, double radius);

/// Returns t_d = 3/2 (tau - 1/2) + 1 [step], the sum of three delays:
/// - The stress of the fluid lags behind the rate of strain by tau - 1/2.
/// - The finite speed of sound adds (tau - 1/2)/2.
/// - The coupling once per step adds 1.
constexpr double force_delay(double relaxation_time) {
  return 1.5 * (relaxation_time - 0.5) + 1;
}

/// Returns 9 nu t_d/(2 R^2), the density [density of the fluid] that compensates the delay for a bead in
/// lattice units. nu is the kinematic viscosity, R the radius of the bead and t_d = force_delay() the delay
/// of the force.
double delay_density(const Bead& bead, double relaxation_time);

}  // namespace beadswim
