#pragma once

#include <optional>
#include <string>

#include "beadswim/theory/methods.hpp"
#include "beadswim/theory/perturbation.hpp"

// What all second-order methods say of how far they can be trusted.

namespace beadswim {

/// The velocity of exact Stokes flow as well as it is known: second-order Rotne-Prager theory over its known
/// excess. None where no reference is known, or where the swimmer does not move.
std::optional<double> estimated_exact_velocity(const CollinearSwimmer& swimmer,
                                               const SecondOrderMotion& rotne_prager);

/// Relative difference of `velocity` from `exact` and the change at finite amplitude, added as squares.
std::optional<double> relative_uncertainty(double velocity, std::optional<double> exact,
                                           double amplitude_change);

/// Whether the beads stay apart over the whole stroke.
bool beads_stay_apart(const CollinearSwimmer& swimmer, const Stroke& stroke);

/// Sets `usable` and completes `validity` and `settings` with what holds for all second-order methods:
/// unbounded fluid, no inertia, small amplitude.
void add_common_limits(const Question& question, Prediction& prediction);

}  // namespace beadswim
