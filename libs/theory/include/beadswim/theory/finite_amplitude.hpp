#pragma once

#include "beadswim/theory/collinear_swimmer.hpp"
#include "beadswim/theory/periodic_motion.hpp"

// Leading relative change of the swimmer's velocity beyond second order in the driving amplitude.
//
//   V = V_2 (1 + c s^2 + ..)   for driving forces s A, s B,   c = lim_{s -> 0} (V/V_2 - 1)/s^2
//
//   V      velocity of the periodic motion [length/time]
//   V_2    velocity to second order in s [length/time]
//   s      factor by which the driving amplitudes A and B are multiplied
//
// c is evaluated from the periodic motion at a small s. The mobility is interpolated between a few bead
// configurations close to rest. Page: docs/method/harmonic-balance.md.

namespace beadswim {

/// Returns c, the leading relative change of the swimmer's velocity V in open space because the driving
/// amplitude is finite: V = V_2 (1 + c + ..), where V_2 is the velocity to second order in the driving
/// amplitude. Returns 0 if V_2 is zero within roundoff, and NaN if beads touch or overlap at rest.
double finite_amplitude_change(const CollinearSwimmer& swimmer, const MobilityFunction& mobility);

}  // namespace beadswim
