#include <fmt/format.h>

#include <cmath>

#include "beadswim/mobility/oseen.hpp"
#include "beadswim/mobility/rotne_prager.hpp"
#include "beadswim/theory/perturbation.hpp"
#include "beadswim/theory/truncation_error.hpp"
#include "confidence.hpp"
#include "method_rows.hpp"

namespace beadswim {

namespace {

/// How far a velocity lies from exact Stokes flow, in words.
std::string distance_from_exact(const CollinearSwimmer& swimmer, double velocity,
                                std::optional<double> exact) {
  const double ratio = separation_ratio(swimmer);
  if (!exact) return fmt::format("no reference at separation/radius {:.3g}, or no motion", ratio);
  const double percent = 100 * (velocity / *exact - 1);
  return fmt::format("velocity about {:.1f} % {} exact Stokes flow at separation/radius {:.3g}",
                     std::abs(percent), percent < 0 ? "below" : "above", ratio);
}

Prediction predict_perturbation(const Question& question, const std::string& pairs, PairLaw law) {
  const CollinearSwimmer& swimmer = question.swimmer;
  const SecondOrderMotion motion = second_order_motion(swimmer, rest_mobility(swimmer, law));
  const std::optional<double> exact =
      estimated_exact_velocity(swimmer, second_order_motion(swimmer, rest_mobility(swimmer, rotne_prager)));

  Prediction prediction;
  prediction.velocity = motion.velocity;
  prediction.stroke = motion.stroke;
  prediction.sin_phase_shift = motion.stroke.sin_phase_shift();
  prediction.arm_means = {swimmer.arm[0] + motion.arm_changes[0], swimmer.arm[1] + motion.arm_changes[1]};
  prediction.uncertainty =
      relative_uncertainty(motion.velocity, exact, finite_amplitude_change(swimmer, motion.stroke.amplitude));
  prediction.validity = fmt::format("{} pairs, no truncation in lambda/l; {}", pairs,
                                    distance_from_exact(swimmer, motion.velocity, exact));
  prediction.settings.emplace_back("pair_mobility", pairs);
  add_common_limits(question, prediction);
  return prediction;
}

}  // namespace

std::optional<std::string> perturbation_obstacle(const Question& question) {
  constexpr double touching = 2;
  if (separation_ratio(question.swimmer) >= touching) return std::nullopt;
  return "beads overlap at rest; it needs arms longer than the sum of the radii at their ends";
}

Prediction predict_oseen_perturbation(const Question& question) {
  return predict_perturbation(question, "Oseen", oseen);
}

Prediction predict_rpy_perturbation(const Question& question) {
  return predict_perturbation(question, "Rotne-Prager", rotne_prager);
}

}  // namespace beadswim
