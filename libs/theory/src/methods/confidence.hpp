#pragma once

#include <optional>
#include <string>

#include "beadswim/theory/periodic_motion.hpp"
#include "beadswim/theory/prediction.hpp"
#include "beadswim/theory/question.hpp"

// What methods of one kind say alike: their motion, and how far they can be trusted.

namespace beadswim {

/// Velocity, stroke and mean arms of a motion, as a prediction begins.
Prediction prediction_from(const CollinearSwimmer& swimmer, const SecondOrderMotion& motion);
Prediction prediction_from(const PeriodicMotion& motion);

/// Whether the beads stay apart over the whole stroke about the arms' rest lengths.
bool beads_stay_apart(const CollinearSwimmer& swimmer, const Stroke& stroke);

/// Velocity of exact Stokes flow to second order in amplitude; none where it is not known or roundoff.
std::optional<double> exact_velocity(const Question& question);

/// Velocity of exact Stokes flow with this stroke, by its geometry factor [length/time]; needs the exact
/// reference.
double exact_stroke_velocity(const Question& question, const Stroke& stroke);

/// The same; none where it is not known or roundoff.
std::optional<double> exact_velocity_of(const Question& question, const Stroke& stroke);

/// Relative difference of `velocity` from `exact` and the `change` at finite amplitude, added as squares.
std::optional<double> relative_uncertainty(double velocity, std::optional<double> exact, double change);

/// "11.8 % above exact Stokes flow at l/lambda 5", or that this is not known.
std::string distance_from_exact(const Question& question, double velocity, std::optional<double> exact);

/// Appends what is wrong to `validity` and marks the prediction as not usable.
void refuse(Prediction& prediction, const std::string& reason);

/// Not usable if the beads would meet within the prediction's stroke.
void refuse_contact(const Question& question, Prediction& prediction);

/// Appends to `validity` how much of the velocity second order leaves out; needs the exact reference.
void add_amplitude_limit(const Question& question, Prediction& prediction);

/// Settings that all methods share: the swimmer's driving and dimensionless numbers.
void add_driving_settings(const Question& question, Prediction& prediction);

/// Limits and settings of second-order methods in open space: small amplitude, no inertia.
void add_common_limits(const Question& question, Prediction& prediction);

/// sqrt(2 nu / omega) over the mean arm: how far vorticity spreads in a period.
double penetration_depth_over_arm(const Question& question);

}  // namespace beadswim
