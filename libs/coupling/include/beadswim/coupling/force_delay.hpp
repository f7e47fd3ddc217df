#pragma once

#include "beadswim/swimmers/swimmer_type.hpp"

// The fluid's force on a bead comes late on the lattice, by a time t_d whatever the bead:
//
//   F(t) = -zeta u(t - t_d) = -zeta u + zeta t_d du/dt + O(omega^2 t_d^2),     zeta = 6 pi eta R
//
// so that a bead of mass m acts as one of m - zeta t_d. One that is heavier by zeta t_d acts as it should,
// and momentum is conserved as before. See docs/method/force-delay.md.

namespace beadswim {

/// t_d = 3/2 (tau - 1/2) + 1 [step]: the fluid's stress follows its rate of strain after tau - 1/2, the
/// finite speed of sound adds half of that, and the coupling in steps adds one.
constexpr double force_delay(double relaxation_time) {
  return 1.5 * (relaxation_time - 0.5) + 1;
}

/// The bead in lattice units, denser by what makes up for the delay: 9 nu t_d / (2 R^2) of the fluid's
/// density. Its moment of inertia grows in proportion, by a third or so of what its torque's delay takes.
Bead made_up_for_delay(Bead bead, double relaxation_time);

}  // namespace beadswim
