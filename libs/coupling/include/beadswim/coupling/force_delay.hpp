#pragma once

#include "beadswim/swimmers/swimmer_type.hpp"

// On the lattice, the force of the fluid on a bead lags by a time t_d, which is the same for every bead:
//
//   F(t) = -zeta u(t - t_d) = -zeta u + zeta t_d du/dt + O(omega^2 t_d^2),     zeta = 6 pi eta R
//
// A bead of mass m therefore moves like a bead of mass m - zeta t_d. A bead whose mass is larger by zeta t_d
// moves correctly, and momentum is still conserved. See docs/method/force-delay.md.

namespace beadswim {

/// Returns t_d = 3/2 (tau - 1/2) + 1 [step]. The stress of the fluid lags behind the rate of strain by tau -
/// 1/2, the finite speed of sound adds (tau - 1/2)/2, and the coupling once per step adds 1.
constexpr double force_delay(double relaxation_time) {
  return 1.5 * (relaxation_time - 0.5) + 1;
}

/// Returns a bead (lattice units) whose density is increased by 9 nu t_d/(2 R^2) [density of the fluid],
/// which compensates the delay of the force. Its moment of inertia increases in proportion. This compensates
/// about a third of the delay of the torque.
Bead with_delay_correction(Bead bead, double relaxation_time);

}  // namespace beadswim
