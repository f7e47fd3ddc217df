#include <fmt/format.h>

#include <cmath>

#include "beadswim/core/setting.hpp"
#include "beadswim/mobility/oseen.hpp"
#include "beadswim/mobility/rotne_prager.hpp"
#include "beadswim/theory/closed_forms.hpp"
#include "beadswim/theory/linear_response.hpp"
#include "beadswim/theory/perturbation.hpp"
#include "confidence.hpp"
#include "method_rows.hpp"

namespace beadswim {

namespace {

constexpr const char* remedy = "use a method whose name ends in -perturbation";

bool equal(double a, double b) {
  constexpr double roundoff = 1e-12;  // relative error of a unit conversion
  return std::abs(a - b) <= roundoff * std::abs(a);
}

std::optional<std::string> unequal_shape(const CollinearSwimmer& swimmer, const UnitScales& units) {
  const auto& radius = swimmer.radius;
  if (!equal(radius[0], radius[1]) || !equal(radius[0], radius[2])) {
    return fmt::format("the bead radii {}, {}, {} differ, but the closed form requires equal radii; {}",
                       radius[0] * units.length, radius[1] * units.length, radius[2] * units.length, remedy);
  }
  if (!equal(swimmer.arm[0], swimmer.arm[1])) {
    return fmt::format("the arm lengths {}, {} differ, but the closed form requires equal arm lengths; {}",
                       swimmer.arm[0] * units.length, swimmer.arm[1] * units.length, remedy);
  }
  return std::nullopt;
}

std::optional<std::string> unequal_response(const CollinearSwimmer& swimmer, const UnitScales& units) {
  if (!equal(swimmer.stiffness[0], swimmer.stiffness[1])) {
    return fmt::format("the stiffnesses {}, {} differ, but the closed form requires equal stiffnesses; {}",
                       swimmer.stiffness[0] * units.stiffness(), swimmer.stiffness[1] * units.stiffness(),
                       remedy);
  }
  if (swimmer.damping[0] != 0 || swimmer.damping[1] != 0) {
    return fmt::format("the closed form neglects damping, but the springs have the damping {}, {}; {}",
                       swimmer.damping[0] * units.damping(), swimmer.damping[1] * units.damping(), remedy);
  }
  return std::nullopt;
}

/// Returns a pair mobility of zero. Equations (4.4) to (4.8) of Pickl et al. 2017 are exact for beads without
/// hydrodynamic interaction.
PairMobility no_interaction(double, double, double, double) {
  return {};
}

/// Returns the stroke under the driving forces to lowest order in lambda/l (bead radius/arm length), with the
/// arm amplitudes of equations (4.4) and (4.5) of Pickl et al. 2017. The paper states only the phase
/// difference of the arms, equation (4.6). The phase of each arm is taken from the linear response without
/// hydrodynamic interaction.
Stroke lowest_order_stroke(const CollinearSwimmer& swimmer) {
  Stroke stroke = first_order_stroke(swimmer, no_interaction);
  const auto [d1, d2] = oseen_arm_amplitudes(swimmer);
  stroke.amplitude = {d1, d2};
  return stroke;
}

constexpr const char* measured_origin = "measured";
constexpr const char* driven_origin = "predicted by (4.4) to (4.8)";

/// Velocity [length/time] and stroke by a closed formula, with texts for users: where the stroke comes from,
/// whether the formula is valid, and which pair mobility it uses.
struct Formula {
  double velocity = 0;
  Stroke stroke;
  double sin_phase_shift = 0;
  std::string stroke_origin;
  std::string verdict;
  std::string pairs;
};

/// Relative difference from the velocity in exact Stokes flow below which a truncated formula is usable.
constexpr double usable_distance = 0.25;

/// Returns the velocity in exact Stokes flow with which a formula is compared. For a measured stroke, this is
/// the velocity of the same stroke, because only the geometry factor of the formula can be wrong.
std::optional<double> exact_reference_velocity(const Question& question, const Formula& formula) {
  const bool measured = formula.stroke_origin == measured_origin;
  return measured ? exact_velocity_for_stroke(question, formula.stroke) : exact_velocity(question);
}

/// Returns the prediction by a formula. `validity`: text about the range of validity, to which known limits
/// are appended.
Prediction make_prediction(const Question& question, const Formula& formula, const std::string& validity) {
  Prediction prediction;
  prediction.velocity = formula.velocity;
  prediction.stroke = formula.stroke;
  prediction.sin_phase_shift = formula.sin_phase_shift;
  prediction.validity = validity;
  if (question.exact) {
    prediction.uncertainty = relative_uncertainty(
        formula.velocity, exact_reference_velocity(question, formula), question.exact->amplitude_change);
  }
  prediction.settings.emplace_back("mobility", formula.pairs);
  prediction.settings.emplace_back("stroke", formula.stroke_origin);
  add_common_limits(question, prediction);
  return prediction;
}

/// Returns the prediction by a formula. Its text about validity states the relative distance from exact
/// Stokes flow.
Prediction compared_prediction(const Question& question, const Formula& formula) {
  const bool measured = formula.stroke_origin == measured_origin;
  const std::string distance =
      distance_from_exact(question, formula.velocity, exact_reference_velocity(question, formula));
  return make_prediction(question, formula,
                         formula.verdict + ": here " + distance + (measured ? ", of this stroke" : ""));
}

/// Returns the prediction by a formula, marked as not usable unless its velocity is within `usable_distance`
/// of the velocity in exact Stokes flow.
Prediction usable_if_close(const Question& question, const Formula& formula) {
  Prediction prediction = compared_prediction(question, formula);
  const std::optional<double> exact = exact_reference_velocity(question, formula);
  const bool near = exact && std::abs(formula.velocity / *exact - 1) < usable_distance;
  if (!near)
    mark_unusable(prediction, fmt::format("the velocity by this formula is not known to be within {:.0f} % "
                                          "of the velocity in exact Stokes flow",
                                          100 * usable_distance));
  return prediction;
}

/// Returns a formula whose stroke follows from the driving to first order with the pair mobility `law`. The
/// velocity is not yet set. `pairs`: name of the law for users.
Formula formula_for_driven_stroke(const Question& question, PairLaw law, const std::string& pairs) {
  Formula formula;
  formula.pairs = pairs;
  formula.stroke = first_order_stroke(question.swimmer, law);
  formula.stroke_origin = "predicted, " + pairs + " pairs";
  formula.sin_phase_shift = formula.stroke.sin_phase_shift();
  return formula;
}

/// Returns a formula with the measured stroke or, if none was measured, with the stroke that follows from the
/// driving. The velocity is not yet set.
Formula formula_for_given_stroke(const Question& question, PairLaw law, const std::string& pairs) {
  Formula formula = formula_for_driven_stroke(question, law, pairs);
  if (!question.measured_stroke) return formula;
  formula.stroke = *question.measured_stroke;
  formula.stroke_origin = measured_origin;
  formula.sin_phase_shift = formula.stroke.sin_phase_shift();
  return formula;
}

}  // namespace

std::optional<std::string> equal_shape_obstacle(const Question& question) {
  if (auto obstacle = overlap_obstacle(question)) return obstacle;
  return unequal_shape(question.swimmer, question.units);
}

std::optional<std::string> equal_parts_obstacle(const Question& question) {
  if (auto obstacle = equal_shape_obstacle(question)) return obstacle;
  return unequal_response(question.swimmer, question.units);
}

std::optional<std::string> rpy_force_printed_obstacle(const Question& question) {
  if (auto obstacle = equal_parts_obstacle(question)) return obstacle;
  const auto& [A, B] = question.swimmer.amplitude;
  if (equal(A, B)) return std::nullopt;
  return fmt::format(
      "equation (4.23) of Pickl et al. 2017 requires equal driving amplitudes A = B, but they are {}, {}; "
      "use rpy-force-repaired",
      A * question.units.force(), B * question.units.force());
}

std::optional<std::string> oseen_stroke_obstacle(const Question& question) {
  // Equations (4.4) to (4.8) of the paper predict the stroke for equal springs only. A measured stroke does
  // not require these equations.
  return question.measured_stroke ? equal_shape_obstacle(question) : equal_parts_obstacle(question);
}

std::optional<std::string> measured_stroke_obstacle(const Question& question) {
  if (auto obstacle = exact_obstacle(question)) return obstacle;
  if (question.measured_stroke) return std::nullopt;
  return fmt::format("the method needs a measured stroke; give one with {}", Setting::stroke_record);
}

Prediction predict_oseen_force(const Question& question) {
  return compared_prediction(question,
                             {.velocity = oseen_force_velocity(question.swimmer),
                              .stroke = lowest_order_stroke(question.swimmer),
                              .sin_phase_shift = oseen_sin_phase_shift(question.swimmer),
                              .stroke_origin = driven_origin,
                              .verdict = "(4.3) with (4.4) to (4.8), right to lowest order in lambda/l",
                              .pairs = "Oseen"});
}

Prediction predict_oseen_stroke(const Question& question) {
  Formula formula;
  if (question.measured_stroke) {
    formula = formula_for_given_stroke(question, oseen, "Oseen");
  } else {
    formula.stroke = lowest_order_stroke(question.swimmer);
    formula.stroke_origin = driven_origin;
    formula.sin_phase_shift = oseen_sin_phase_shift(question.swimmer);
    formula.pairs = "Oseen";
  }
  formula.velocity = oseen_stroke_velocity(question.swimmer, formula.stroke);
  formula.verdict = "(4.2), right to lowest order in lambda/l";
  return compared_prediction(question, formula);
}

Prediction predict_oseen_ratio_printed(const Question& question) {
  const CollinearSwimmer& swimmer = question.swimmer;
  Prediction prediction =
      compared_prediction(question, {.velocity = oseen_ratio_printed(swimmer) * oseen_force_velocity(swimmer),
                                     .stroke = lowest_order_stroke(swimmer),
                                     .sin_phase_shift = oseen_sin_phase_shift(swimmer),
                                     .stroke_origin = driven_origin,
                                     .verdict = "(4.9) as printed, v_S from v_F of (4.3)",
                                     .pairs = "Oseen"});
  mark_unusable(prediction,
                "for the stroke of equations (4.4) to (4.8) of Pickl et al. 2017, the velocities v_S of "
                "equation (4.2) and v_F "
                "of equation (4.3) are equal, so their ratio (4.9) does not hold");
  return prediction;
}

Prediction predict_oseen_ratio_repaired(const Question& question) {
  Formula formula = formula_for_given_stroke(question, oseen, "Oseen");
  formula.velocity =
      oseen_stroke_velocity(question.swimmer, formula.stroke) / oseen_ratio_repaired(question.swimmer);
  formula.verdict =
      "(4.9) as it should be, (4.2) over the right ratio: untruncated Oseen theory of this stroke";
  return compared_prediction(question, formula);
}

Prediction predict_rpy_force_printed(const Question& question) {
  Formula formula = formula_for_driven_stroke(question, rotne_prager, "Rotne-Prager");
  formula.velocity = rpy_force_velocity_printed(question.swimmer);
  formula.verdict =
      "(4.23) as printed, wrong: 8l - 33 lambda should be 10l - 33 lambda, a factor sin alpha is missing, "
      "and its k^4 term vanishes at l = 5 lambda";
  return usable_if_close(question, formula);
}

Prediction predict_rpy_force_repaired(const Question& question) {
  Formula formula = formula_for_driven_stroke(question, rotne_prager, "Rotne-Prager");
  formula.velocity = rpy_force_velocity_repaired(question.swimmer);
  formula.verdict =
      "(4.23) mended in its own scheme, which truncates in lambda/l, drops the mean change of the arms and "
      "is poor at small l/lambda";
  return usable_if_close(question, formula);
}

Prediction predict_rpy_stroke_printed(const Question& question) {
  Formula formula = formula_for_given_stroke(question, rotne_prager, "Rotne-Prager");
  formula.velocity = rpy_stroke_velocity(question.swimmer, formula.stroke);
  formula.verdict = "(4.24), right as a truncation in lambda/l, with a pole at l = 4.25 lambda";
  return usable_if_close(question, formula);
}

Prediction predict_rpy_equal_weight(const Question& question) {
  Formula formula = formula_for_given_stroke(question, rotne_prager, "Rotne-Prager");
  formula.velocity = equal_weight_velocity(question.swimmer, formula.stroke);
  formula.verdict =
      "equal-weight mean of the beads' velocities as in (4.18), without truncation in lambda/l but without "
      "the mean change of the arms, which the periodic motion has";
  return compared_prediction(question, formula);
}

Prediction predict_multipole_stroke(const Question& question) {
  Formula formula = formula_for_given_stroke(question, rotne_prager, "exact");
  formula.velocity = exact_stroke_velocity(question, formula.stroke);
  return make_prediction(question, formula,
                         "exact Stokes flow of three spheres (axisymmetric multipoles) with this stroke");
}

}  // namespace beadswim
