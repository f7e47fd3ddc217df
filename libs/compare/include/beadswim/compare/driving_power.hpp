#pragma once

#include <optional>
#include <span>

#include "beadswim/compare/cycle_statistics.hpp"
#include "beadswim/swimmers/swimmer_type.hpp"

namespace beadswim {

/// Returns the mean power P of the drives in one cycle [mass length^2/time^3]: the work of forces and
/// tensions on the beads, and of driven rest lengths and rest angles on their springs.
///
/// Each harmonic of a drive, A sin(n w t + psi) with psi = n phi + phase, acts on one coordinate q: a force
/// on the coordinate of its bead along the force, the drives of a bond on its length L, that of an angle on
/// the angle theta. Only the part d cos(n w t + delta) of q contributes, at any amplitude:
///
///   P_force   = -n w/2 A d cos(delta - psi),     P_tension = n w/2 A d cos(delta - psi)
///   P_rest    = -k n w/2 A d cos(delta - psi)    k: stiffness of the bond, or angular stiffness
///
/// A constant force F does the power F times the mean velocity of its bead along the force.
///
///   samples              as for cycle_statistics()
///   initial_orientation  of the swimmer at the start of the run
/// Forces that turn with the swimmer (DrivingFrame::body) have no such coordinate. Their power is the mean of
/// force times velocity at the samples, with velocities by trigonometric interpolation; it is exact for a
/// periodic motion.
///
/// Returns nothing if the samples do not resolve a harmonic. Throws InputError as fit_cycle() does.
std::optional<double> driving_power(const SwimmerType& type, const Eigen::Matrix3d& initial_orientation,
                                    std::span<const SwimmerSample> samples);

}  // namespace beadswim
