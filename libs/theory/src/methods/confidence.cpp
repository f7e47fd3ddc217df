#include "confidence.hpp"

#include <fmt/core.h>

#include <cmath>

#include "beadswim/theory/linear_response.hpp"

namespace beadswim {

namespace {

/// Returns the velocity; nullopt if it is only roundoff.
std::optional<double> nullopt_if_roundoff(const Question& question, double velocity, const Stroke& stroke) {
  constexpr double relative_roundoff = 1e-12;
  if (std::abs(velocity) > relative_roundoff * second_order_scale(question.line(), stroke)) return velocity;
  return std::nullopt;
}

}  // namespace

Prediction prediction_from(const PeriodicMotion& motion, std::span<const double> rest_lengths) {
  Prediction prediction;
  prediction.velocity = motion.velocity;
  prediction.stroke = motion.stroke;
  prediction.sin_phase_shift = motion.stroke.sin_phase_shift();
  prediction.dipole = motion.dipole;
  prediction.arm_means.emplace();
  for (std::size_t k = 0; k < rest_lengths.size(); ++k)
    prediction.arm_means->push_back(rest_lengths[k] + motion.arm_changes[k]);
  return prediction;
}

bool beads_stay_apart(const CollinearSwimmer& swimmer, const Stroke& stroke) {
  const std::array<double, 2> gaps = gaps_at_rest(swimmer);
  return gaps[0] > stroke.amplitude[0] && gaps[1] > stroke.amplitude[1];
}

std::optional<double> exact_velocity(const Question& question) {
  if (!question.exact()) return std::nullopt;
  return nullopt_if_roundoff(question, question.exact()->motion.velocity, question.exact()->motion.stroke);
}

double exact_stroke_velocity(const Question& question, const Stroke& stroke) {
  return geometry_factor(question.exact()->mobility) * question.line().angular_frequency() * stroke.area();
}

std::optional<double> exact_velocity_for_stroke(const Question& question, const Stroke& stroke) {
  if (!question.exact()) return std::nullopt;
  return nullopt_if_roundoff(question, exact_stroke_velocity(question, stroke), stroke);
}

std::optional<double> relative_uncertainty(double velocity, std::optional<double> exact, double change) {
  if (!exact) return std::nullopt;
  return std::hypot(velocity / *exact - 1, change);
}

std::string distance_from_exact(const Question& question, double velocity, std::optional<double> exact) {
  const double ratio = separation_ratio(question.line());
  if (!exact) return "at an unknown distance from exact Stokes flow, or at rest";
  const double percent = 100 * (velocity / *exact - 1);
  return fmt::format("{:.3g} % {} exact Stokes flow at l/lambda {:.3g}", std::abs(percent),
                     percent < 0 ? "below" : "above", ratio);
}

void mark_unusable(Prediction& prediction, const std::string& reason) {
  prediction.usable = false;
  prediction.validity += "; not usable: " + reason;
}

void mark_unusable_if_beads_touch(const Question& question, Prediction& prediction) {
  if (!beads_stay_apart(question.line(), prediction.stroke)) {
    mark_unusable(prediction, "with this stroke the beads would run into each other");
  }
}

double penetration_depth_over_arm(const Question& question) {
  const double nu = question.line().viscosity / question.fluid_density();
  const double depth = std::sqrt(2 * nu / question.line().angular_frequency());
  return 2 * depth / (question.line().arm[0] + question.line().arm[1]);
}

void add_driving_settings(const Question& question, Prediction& prediction) {
  const CollinearSwimmer& swimmer = question.line();
  const auto& [A, B] = swimmer.amplitude;
  prediction.settings.emplace_back("period", swimmer.period);
  prediction.settings.emplace_back("amplitude", A);
  if (B != 0) prediction.settings.emplace_back("amplitude_ratio", A / B);
  prediction.settings.emplace_back("phase", swimmer.phase);
  prediction.settings.emplace_back("separation_ratio", separation_ratio(swimmer));
  prediction.settings.emplace_back("penetration_depth_over_arm", penetration_depth_over_arm(question));
}

void add_amplitude_limit(const Question& question, Prediction& prediction) {
  prediction.validity +=
      fmt::format("; second order in amplitude, which leaves out about {:+.1f} % of the velocity",
                  100 * question.exact()->amplitude_change);
}

void add_common_limits(const Question& question, Prediction& prediction) {
  if (question.exact()) add_amplitude_limit(question, prediction);
  prediction.validity +=
      fmt::format("; alone in unbounded fluid; no inertia of fluid or beads (penetration depth {:.2f} arms)",
                  penetration_depth_over_arm(question));
  mark_unusable_if_beads_touch(question, prediction);
  prediction.settings.emplace_back("fluid", "unbounded");
  add_driving_settings(question, prediction);
}

}  // namespace beadswim
