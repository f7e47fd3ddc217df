#pragma once

#include "beadswim/theory/collinear_swimmer.hpp"
#include "beadswim/theory/periodic_motion.hpp"

// What second order in amplitude leaves out: the next order, as a number.
//
//   V = V_2 (1 + c s^2 + ..)   for driving forces s A, s B,   c = lim (V/V_2 - 1)/s^2
//
// by the periodic motion at a small s, the mobility taken from a few places of the beads about their rest.
// Page: docs/method/harmonic-balance.md.

namespace beadswim {

/// c: relative change of the velocity at finite amplitude, to leading order, in open space. 0 where nothing
/// moves but by roundoff, NaN for beads that overlap at rest.
double finite_amplitude_change(const CollinearSwimmer& swimmer, const MobilityAt& mobility);

}  // namespace beadswim
