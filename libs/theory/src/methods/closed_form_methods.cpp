#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <span>

#include "beadswim/collinear/oseen.hpp"
#include "beadswim/collinear/rotne_prager.hpp"
#include "beadswim/core/setting.hpp"
#include "beadswim/theory/closed_forms.hpp"
#include "beadswim/theory/linear_response.hpp"
#include "confidence.hpp"
#include "method_rows.hpp"

namespace beadswim {

namespace {

constexpr const char* usual_remedy = "use a method whose name ends in -perturbation";

bool equal(double a, double b) {
  constexpr double roundoff = 1e-12;  // relative error of a unit conversion
  return std::abs(a - b) <= roundoff * std::abs(a);
}

/// Returns a message if the values differ; else an empty text. `unit`: of the values, in the units of the
/// layout.
std::string unequal(const std::string& what, std::span<const double> values, double unit,
                    const std::string& remedy = usual_remedy) {
  if (std::ranges::all_of(values, [&](double value) { return equal(values[0], value); })) return {};
  std::vector<double> in_layout;
  for (const double value : values) in_layout.push_back(value * unit);
  return fmt::format("the {0} {1} differ, but the closed form requires equal {0}; {2}", what,
                     fmt::join(in_layout, ", "), remedy);
}

/// Returns why closed forms for equal beads and equal arms cannot treat the question; empty if they can.
std::string unequal_shape(const Question& question) {
  if (std::string obstacle = overlap_obstacle(question); !obstacle.empty()) return obstacle;
  const double unit = question.units().length;
  std::string obstacle = unequal("bead radii", question.line().radius, unit);
  return obstacle.empty() ? unequal("arm lengths", question.line().arm, unit) : obstacle;
}

/// Returns the same for closed forms that contain the driving.
std::string unequal_parts(const Question& question) {
  if (std::string obstacle = unequal_shape(question); !obstacle.empty()) return obstacle;
  const CollinearSwimmer& swimmer = question.line();
  const UnitScales& units = question.units();
  if (swimmer.damping != std::array{0.0, 0.0})
    return fmt::format("the closed form neglects damping, but the springs have the damping {}, {}; {}",
                       swimmer.damping[0] * units.damping(), swimmer.damping[1] * units.damping(),
                       usual_remedy);
  return unequal("stiffnesses", swimmer.stiffness, units.stiffness());
}

std::string unequal_parts_or_amplitudes(const Question& question) {
  const std::string obstacle = unequal_parts(question);
  return obstacle.empty() ? unequal("driving amplitudes", question.line().amplitude, question.units().force(),
                                    "use rpy-force-repaired")
                          : obstacle;
}

std::string unequal_for_lowest_order_stroke(const Question& question) {
  // Equations (4.4) to (4.8) of the paper predict the stroke for equal springs only. A measured stroke does
  // not require these equations.
  return question.measured_stroke ? unequal_shape(question) : unequal_parts(question);
}

std::string no_measured_stroke(const Question& question) {
  if (std::string obstacle = exact_obstacle(question); !obstacle.empty()) return obstacle;
  if (question.measured_stroke) return {};
  return fmt::format("the method needs a measured stroke; give one with {} RUN.json", Setting::stroke_record);
}

/// Returns a pair mobility of zero. Equations (4.4) to (4.8) of Pickl et al. 2017 are exact for beads without
/// hydrodynamic interaction.
PairMobility no_interaction(double, double, double, double) {
  return {};
}

/// Use of a prediction: always, never, or only if its velocity is within `usable_distance` of exact Stokes
/// flow. `exact`: the velocity is that of exact Stokes flow, so that a comparison says nothing.
enum class Use { always, if_close, never, exact };

/// Relative difference from the velocity in exact Stokes flow below which a truncated formula is usable.
constexpr double usable_distance = 0.25;

/// A method by a closed formula.
struct ClosedForm {
  const char* method;
  Method::Input input;
  std::string (*obstacle)(const Question& question);
  /// Pair mobility from which the stroke follows to first order in the driving. no_interaction: the stroke of
  /// equations (4.4) to (4.8), to lowest order in lambda/l (bead radius/arm length).
  PairLaw stroke_law;
  Use use;
  const BeadMobility& mobility;
  const char* validity;  ///< equation of the paper (closed_forms.hpp), and whether it is valid
  double (*velocity)(const Question& question, const Stroke& stroke);  ///< [length/time]
};

const std::vector<ClosedForm>& closed_forms() {
  using enum Method::Input;
  using enum Use;
  using Q = const Question&;
  using S = const Stroke&;
  // clang-format off
  static const std::vector<ClosedForm> table{
      {"oseen-force-closed", driving, unequal_parts, no_interaction, always, oseen_beads,
       "(4.3) with (4.4) to (4.8), right to lowest order in lambda/l",
       [](Q q, S) { return oseen_force_velocity(q.line()); }},
      {"oseen-stroke-closed", driving_or_stroke, unequal_for_lowest_order_stroke, no_interaction, always, oseen_beads,
       "(4.2), right to lowest order in lambda/l",
       [](Q q, S stroke) { return oseen_stroke_velocity(q.line(), stroke); }},
      {"oseen-ratio-printed", driving, unequal_parts, no_interaction, never, oseen_beads,
       "(4.9) as printed, v_S from v_F of (4.3)",
       [](Q q, S) { return oseen_ratio_printed(q.line()) * oseen_force_velocity(q.line()); }},
      {"oseen-ratio-repaired", driving_or_stroke, unequal_shape, oseen, always, oseen_beads,
       "(4.9) as it should be, (4.2) over the right ratio: untruncated Oseen theory of this stroke",
       [](Q q, S stroke) { return oseen_stroke_velocity(q.line(), stroke) / oseen_ratio_repaired(q.line()); }},
      {"rpy-force-printed", driving, unequal_parts_or_amplitudes, rotne_prager, if_close, rotne_prager_beads,
       "(4.23) as printed, wrong: 8l - 33 lambda should be 10l - 33 lambda, a factor sin alpha is missing, "
       "and its k^4 term vanishes at l = 5 lambda",
       [](Q q, S) { return rpy_force_velocity_printed(q.line()); }},
      {"rpy-force-repaired", driving, unequal_parts, rotne_prager, if_close, rotne_prager_beads,
       "(4.23) mended in its own scheme, which truncates in lambda/l, drops the mean change of the arms and "
       "is poor at small l/lambda",
       [](Q q, S) { return rpy_force_velocity_repaired(q.line()); }},
      {"rpy-stroke-printed", driving_or_stroke, unequal_shape, rotne_prager, if_close, rotne_prager_beads,
       "(4.24), right as a truncation in lambda/l, with a pole at l = 4.25 lambda",
       [](Q q, S stroke) { return rpy_stroke_velocity(q.line(), stroke); }},
      {"rpy-equal-weight", driving_or_stroke, unequal_shape, rotne_prager, always, rotne_prager_beads,
       "equal-weight mean of the beads' velocities as in (4.18), without truncation in lambda/l but without "
       "the mean change of the arms, which the periodic motion has",
       [](Q q, S stroke) { return equal_weight_velocity(q.line(), stroke); }},
      {"multipole-stroke", stroke, no_measured_stroke, rotne_prager, exact, exact_beads,
       "exact Stokes flow of three spheres (axisymmetric multipoles) with this stroke", exact_stroke_velocity},
  };
  // clang-format on
  return table;
}

/// A stroke, and where it comes from.
struct GivenStroke {
  Stroke stroke;
  double sin_phase_shift = 0;
  std::string origin;
};

/// Returns the measured stroke if the formula uses it, else the stroke that follows from the driving. The
/// paper states only the phase difference of the arms, equation (4.6). With equations (4.4) to (4.8), the
/// phase of each arm is taken from the linear response without hydrodynamic interaction.
GivenStroke stroke_for(const ClosedForm& form, const Question& question, bool is_measured) {
  if (is_measured)
    return {*question.measured_stroke, question.measured_stroke->sin_phase_shift(), "measured"};
  Stroke stroke = first_order_stroke(question.line(), form.stroke_law);
  if (form.stroke_law != no_interaction)
    return {stroke, stroke.sin_phase_shift(), fmt::format("predicted, {} pairs", form.mobility.name)};
  std::ranges::copy(oseen_arm_amplitudes(question.line()), stroke.amplitude.begin());
  return {stroke, oseen_sin_phase_shift(question.line()), "predicted by (4.4) to (4.8)"};
}

void mark_unusable_by(Use use, double velocity, std::optional<double> exact, Prediction& prediction) {
  if (use == Use::never)
    mark_unusable(prediction,
                  "for the stroke of equations (4.4) to (4.8) of Pickl et al. 2017, the velocities v_S of "
                  "equation (4.2) and v_F of equation (4.3) are equal, so their ratio (4.9) does not hold");
  if (use == Use::if_close && !(exact && std::abs(velocity / *exact - 1) < usable_distance))
    mark_unusable(prediction, fmt::format("the velocity by this formula is not known to be within {:.0f} % "
                                          "of the velocity in exact Stokes flow",
                                          100 * usable_distance));
}

Prediction predict_by(const ClosedForm& form, const Question& question) {
  const bool is_measured = question.measured_stroke && form.input != Method::Input::driving;
  const auto [stroke, sin_phase_shift, origin] = stroke_for(form, question, is_measured);
  const double velocity = form.velocity(question, stroke);
  // For a measured stroke, the velocity in exact Stokes flow is that of the same stroke, because only the
  // geometry factor of the formula can be wrong.
  const std::optional<double> exact =
      is_measured ? exact_velocity_for_stroke(question, stroke) : exact_velocity(question);
  Prediction prediction;
  prediction.velocity = velocity;
  prediction.stroke = stroke;
  prediction.sin_phase_shift = sin_phase_shift;
  prediction.validity = form.validity;
  if (form.use != Use::exact)
    prediction.validity += fmt::format(": here {}{}", distance_from_exact(question, velocity, exact),
                                       is_measured ? ", of this stroke" : "");
  if (question.exact())
    prediction.uncertainty = relative_uncertainty(velocity, exact, question.exact()->amplitude_change);
  prediction.settings.emplace_back("mobility", form.mobility.name);
  prediction.settings.emplace_back("stroke", origin);
  add_common_limits(question, prediction);
  mark_unusable_by(form.use, velocity, exact, prediction);
  return prediction;
}

}  // namespace

std::vector<Method> closed_form_methods() {
  std::vector<Method> methods;
  for (const ClosedForm& form : closed_forms())
    methods.push_back({.name = form.method,
                       .input = form.input,
                       .obstacle_to_line = form.obstacle,
                       .predict = std::bind_front(predict_by, std::cref(form)),
                       .mobility = &form.mobility});
  return methods;
}

}  // namespace beadswim
