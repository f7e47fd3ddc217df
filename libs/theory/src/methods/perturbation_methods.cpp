#include <fmt/core.h>

#include "confidence.hpp"
#include "method_rows.hpp"

namespace beadswim {

std::optional<std::string> overlap_obstacle(const Question& question) {
  const CollinearSwimmer& swimmer = question.swimmer;
  if (smallest_gap(swimmer, rest_positions(swimmer)) >= 0) return std::nullopt;
  const double unit = question.units.length;
  return fmt::format(
      "beads overlap at rest: arms {:.6g}, {:.6g} with radii {:.6g}, {:.6g}, {:.6g}; each arm must be longer "
      "than the sum of the radii at its ends",
      swimmer.arm[0] * unit, swimmer.arm[1] * unit, swimmer.radius[0] * unit, swimmer.radius[1] * unit,
      swimmer.radius[2] * unit);
}

std::optional<std::string> exact_obstacle(const Question& question) {
  if (auto obstacle = overlap_obstacle(question)) return obstacle;
  if (question.exact) return std::nullopt;
  return fmt::format(
      "beads nearly touch at rest (separation ratio l/lambda = {:.5g}), and the multipole series would need "
      "too many terms; use the less accurate method rpy-perturbation",
      separation_ratio(question.swimmer));
}

Prediction predict_pair_perturbation(const BeadMobility& mobility, const Question& question) {
  const SecondOrderMotion motion =
      second_order_motion(question.swimmer, rest_mobility(question.swimmer, mobility.pairs));
  Prediction prediction = prediction_from(question.swimmer, motion);
  const std::optional<double> exact = exact_velocity(question);
  if (question.exact) {
    prediction.uncertainty = relative_uncertainty(motion.velocity, exact, question.exact->amplitude_change);
  }
  prediction.validity = fmt::format("{} pairs, no truncation in lambda/l: here {}", mobility.name,
                                    distance_from_exact(question, motion.velocity, exact));
  prediction.settings.emplace_back("mobility", mobility.name);
  add_common_limits(question, prediction);
  return prediction;
}

Prediction predict_multipole_perturbation(const Question& question) {
  Prediction prediction = prediction_from(question.swimmer, question.exact->motion);
  if (exact_velocity(question)) prediction.uncertainty = std::abs(question.exact->amplitude_change);
  prediction.validity = "exact Stokes flow of three spheres (axisymmetric multipoles)";
  prediction.settings.emplace_back("mobility", "exact");
  add_common_limits(question, prediction);
  return prediction;
}

}  // namespace beadswim
