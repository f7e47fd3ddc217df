#pragma once

#include <optional>
#include <string>

#include "beadswim/theory/periodic_motion.hpp"
#include "beadswim/theory/prediction.hpp"
#include "beadswim/theory/question.hpp"

// Parts of predictions that several methods share: motion, uncertainty, validity and settings.

namespace beadswim {

/// Returns a prediction with the velocity, stroke and mean arms of the motion.
Prediction prediction_from(const CollinearSwimmer& swimmer, const SecondOrderMotion& motion);
Prediction prediction_from(const PeriodicMotion& motion);

/// Returns whether the gaps stay positive if the arms oscillate by `stroke` about their rest lengths.
bool beads_stay_apart(const CollinearSwimmer& swimmer, const Stroke& stroke);

/// Returns the velocity in exact Stokes flow to second order in amplitude [length/time]; nullopt if it is
/// unknown or zero within roundoff.
std::optional<double> exact_velocity(const Question& question);

/// Returns the velocity of this stroke in exact Stokes flow, from the geometry factor [length/time]. Requires
/// `question.exact`.
double exact_stroke_velocity(const Question& question, const Stroke& stroke);

/// Returns exact_stroke_velocity(); nullopt if `question.exact` is not set or the velocity is only roundoff.
std::optional<double> exact_velocity_for_stroke(const Question& question, const Stroke& stroke);

/// Returns sqrt((velocity/exact - 1)^2 + change^2), where `change` is the relative change at finite
/// amplitude; nullopt if `exact` is unknown.
std::optional<double> relative_uncertainty(double velocity, std::optional<double> exact, double change);

/// Returns a text such as "11.8 % above exact Stokes flow at l/lambda 5", or that the distance is unknown.
std::string distance_from_exact(const Question& question, double velocity, std::optional<double> exact);

/// Marks the prediction as not usable and appends the reason to `validity`.
void mark_unusable(Prediction& prediction, const std::string& reason);

/// Marks the prediction as not usable if beads would touch within its stroke.
void mark_unusable_if_beads_touch(const Question& question, Prediction& prediction);

/// Appends to `validity` the part of the velocity that second order neglects. Requires `question.exact`.
void add_amplitude_limit(const Question& question, Prediction& prediction);

/// Adds the settings that all methods share: driving and dimensionless numbers.
void add_driving_settings(const Question& question, Prediction& prediction);

/// Adds validity and settings of second-order methods in open space: small amplitude, no inertia.
void add_common_limits(const Question& question, Prediction& prediction);

/// Returns the penetration depth sqrt(2 nu / omega), divided by the mean rest length of the arms.
double penetration_depth_over_arm(const Question& question);

}  // namespace beadswim
