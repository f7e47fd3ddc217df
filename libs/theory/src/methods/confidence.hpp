#pragma once

#include <optional>
#include <span>
#include <string>

#include "beadswim/theory/periodic_motion.hpp"
#include "beadswim/theory/prediction.hpp"
#include "beadswim/theory/question.hpp"

// Parts of predictions that several methods share: motion, uncertainty, validity and settings.

namespace beadswim {

/// Returns a prediction with the velocity, the stroke and the mean arm lengths of the motion. `rest_lengths`:
/// of the arms [length].
Prediction prediction_from(const PeriodicMotion& motion, std::span<const double> rest_lengths);

/// Returns whether the gaps stay positive if the arms oscillate by `stroke` about their rest lengths.
bool beads_stay_apart(const CollinearSwimmer& swimmer, const Stroke& stroke);

/// Returns the velocity in exact Stokes flow to second order in amplitude [length/time]; nullopt if it is
/// unknown or zero within roundoff.
std::optional<double> exact_velocity(const Question& question);

/// Returns the velocity of `stroke` in exact Stokes flow to second order in amplitude, by the geometry factor
/// [length/time]. Requires `question.exact()`.
double exact_stroke_velocity(const Question& question, const Stroke& stroke);

/// Returns the velocity of `stroke` in exact Stokes flow to second order in amplitude [length/time]; nullopt
/// if `question.exact()` is not set or if the velocity is zero within roundoff.
std::optional<double> exact_velocity_for_stroke(const Question& question, const Stroke& stroke);

/// Returns sqrt((velocity/exact - 1)^2 + change^2), the estimated relative error of a velocity. `exact` is
/// the velocity in exact Stokes flow, `change` the relative change of the velocity at finite amplitude.
/// Returns nullopt if `exact` is unknown.
std::optional<double> relative_uncertainty(double velocity, std::optional<double> exact, double change);

/// Returns a text about the relative difference of `velocity` and `exact`, such as "11.8 % above exact Stokes
/// flow at l/lambda 5", or that the difference is unknown.
std::string distance_from_exact(const Question& question, double velocity, std::optional<double> exact);

/// Marks the prediction as not usable and appends the reason to `validity`.
void mark_unusable(Prediction& prediction, const std::string& reason);

/// Marks the prediction as not usable if beads would touch during the predicted stroke.
void mark_unusable_if_beads_touch(const Question& question, Prediction& prediction);

/// Appends to `validity` the relative change of the velocity that second-order methods neglect. Requires
/// `question.exact()`.
void add_amplitude_limit(const Question& question, Prediction& prediction);

/// Adds the settings that all methods share: driving and dimensionless numbers.
void add_driving_settings(const Question& question, Prediction& prediction);

/// Adds validity and settings that methods of second order in amplitude in open space share: small amplitude,
/// no inertia.
void add_common_limits(const Question& question, Prediction& prediction);

/// Returns the penetration depth sqrt(2 nu / omega), divided by the mean rest length of the arms.
double penetration_depth_over_arm(const Question& question);

}  // namespace beadswim
