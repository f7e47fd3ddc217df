#include <fmt/format.h>

#include "beadswim/mobility/oseen.hpp"
#include "beadswim/mobility/rotne_prager.hpp"
#include "confidence.hpp"
#include "method_rows.hpp"

namespace beadswim {

namespace {

Prediction predict_pairwise(const Question& question, const std::string& pairs, PairLaw law) {
  const SecondOrderMotion motion =
      second_order_motion(question.swimmer, rest_mobility(question.swimmer, law));
  Prediction prediction = prediction_from(question.swimmer, motion);
  const std::optional<double> exact = exact_velocity(question);
  if (question.exact) {
    prediction.uncertainty = relative_uncertainty(motion.velocity, exact, question.exact->amplitude_change);
  }
  prediction.validity = fmt::format("{} pairs, no truncation in lambda/l: here {}", pairs,
                                    distance_from_exact(question, motion.velocity, exact));
  prediction.settings.emplace_back("mobility", pairs);
  add_common_limits(question, prediction);
  return prediction;
}

}  // namespace

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

Prediction predict_oseen_perturbation(const Question& question) {
  return predict_pairwise(question, "Oseen", oseen);
}

Prediction predict_rpy_perturbation(const Question& question) {
  return predict_pairwise(question, "Rotne-Prager", rotne_prager);
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
