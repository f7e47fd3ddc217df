#include <fmt/format.h>

#include <cmath>

#include "beadswim/mobility/rotne_prager.hpp"
#include "beadswim/theory/closed_forms.hpp"
#include "beadswim/theory/linear_response.hpp"
#include "beadswim/theory/perturbation.hpp"
#include "beadswim/theory/truncation_error.hpp"
#include "confidence.hpp"
#include "method_rows.hpp"

namespace beadswim {

namespace {

constexpr const char* remedy = "oseen-perturbation and rpy-perturbation treat any";

bool equal(double a, double b) {
  constexpr double roundoff = 1e-12;  // of a conversion of units
  return std::abs(a - b) <= roundoff * std::abs(a);
}

std::optional<std::string> unequal_shape(const CollinearSwimmer& swimmer) {
  const auto& radius = swimmer.radius;
  if (!equal(radius[0], radius[1]) || !equal(radius[0], radius[2])) {
    return fmt::format("radii {}, {}, {} differ and its closed form is for equal ones; {}", radius[0],
                       radius[1], radius[2], remedy);
  }
  if (!equal(swimmer.arm[0], swimmer.arm[1])) {
    return fmt::format("arms {}, {} differ and its closed form is for equal ones; {}", swimmer.arm[0],
                       swimmer.arm[1], remedy);
  }
  return std::nullopt;
}

std::optional<std::string> unequal_response(const CollinearSwimmer& swimmer) {
  if (!equal(swimmer.stiffness[0], swimmer.stiffness[1])) {
    return fmt::format("stiffnesses {}, {} differ and its closed form is for equal ones; {}",
                       swimmer.stiffness[0], swimmer.stiffness[1], remedy);
  }
  if (swimmer.damping[0] != 0 || swimmer.damping[1] != 0) {
    return fmt::format("its closed form has no dampers, and theirs are {}, {}; {}", swimmer.damping[0],
                       swimmer.damping[1], remedy);
  }
  return std::nullopt;
}

/// No hydrodynamic interaction: the pair law to which (4.4) to (4.8) are exact.
PairMobility no_interaction(double, double, double, double) {
  return {};
}

/// The driven stroke to lowest order in lambda/l: amplitudes by (4.4) and (4.5). The paper gives the
/// difference of the phases alone, (4.6); the phases themselves are of the response that it is taken from.
Stroke lowest_order_stroke(const CollinearSwimmer& swimmer) {
  Stroke stroke = first_order_stroke(swimmer, no_interaction);
  stroke.amplitude = oseen_arm_amplitudes(swimmer);
  return stroke;
}

/// An `applied` expression against the best known velocity of the same swimmer.
void add_confidence(const Question& question, double applied, const SecondOrderMotion& reference,
                    Prediction& prediction) {
  const std::optional<double> exact = estimated_exact_velocity(question.swimmer, reference);
  prediction.uncertainty = relative_uncertainty(
      applied, exact, finite_amplitude_change(question.swimmer, prediction.stroke.amplitude));
  if (exact) {
    prediction.validity += fmt::format(", here about {:+.0f} % from exact Stokes flow at l/lambda {:.3g}",
                                       100 * (applied / *exact - 1), separation_ratio(question.swimmer));
  }
  prediction.settings.emplace_back("pair_mobility", "Oseen");
  add_common_limits(question, prediction);
}

SecondOrderMotion rotne_prager_motion(const CollinearSwimmer& swimmer) {
  return second_order_motion(swimmer, rest_mobility(swimmer, rotne_prager));
}

}  // namespace

std::optional<std::string> oseen_force_obstacle(const Question& question) {
  if (auto obstacle = perturbation_obstacle(question)) return obstacle;
  if (auto obstacle = unequal_shape(question.swimmer)) return obstacle;
  return unequal_response(question.swimmer);
}

Prediction predict_oseen_force(const Question& question) {
  Prediction prediction;
  prediction.velocity = oseen_force_velocity(question.swimmer);
  prediction.stroke = lowest_order_stroke(question.swimmer);
  prediction.sin_phase_shift = oseen_sin_phase_shift(question.swimmer);
  prediction.validity = "(4.3) with (4.4) to (4.8): lowest order in lambda/l";
  add_confidence(question, prediction.velocity, rotne_prager_motion(question.swimmer), prediction);
  return prediction;
}

std::optional<std::string> oseen_stroke_obstacle(const Question& question) {
  if (auto obstacle = perturbation_obstacle(question)) return obstacle;
  if (auto obstacle = unequal_shape(question.swimmer)) return obstacle;
  // A measured stroke holds whatever made it; a predicted one needs (4.4) to (4.8).
  return question.measured_stroke ? std::nullopt : unequal_response(question.swimmer);
}

Prediction predict_oseen_stroke(const Question& question) {
  const bool measured = question.measured_stroke.has_value();
  const CollinearSwimmer& swimmer = question.swimmer;
  Prediction prediction;
  prediction.stroke = measured ? *question.measured_stroke : lowest_order_stroke(swimmer);
  prediction.velocity = oseen_stroke_velocity(swimmer, prediction.stroke);
  prediction.sin_phase_shift =
      measured ? prediction.stroke.sin_phase_shift() : oseen_sin_phase_shift(swimmer);
  prediction.settings.emplace_back("stroke", measured ? "measured" : "predicted by (4.4) to (4.8)");
  prediction.validity = "(4.2): lowest order in lambda/l";
  // Of a measured stroke the geometry factor alone can be wrong: (4.2) is judged on the Rotne-Prager stroke.
  const SecondOrderMotion reference = rotne_prager_motion(swimmer);
  const double applied = measured ? oseen_stroke_velocity(swimmer, reference.stroke) : prediction.velocity;
  add_confidence(question, applied, reference, prediction);
  return prediction;
}

}  // namespace beadswim
