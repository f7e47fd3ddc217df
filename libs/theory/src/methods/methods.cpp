#include "beadswim/theory/methods.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "beadswim/collinear/oseen.hpp"
#include "beadswim/collinear/rotne_prager.hpp"
#include "beadswim/core/error.hpp"
#include "beadswim/core/joined.hpp"
#include "beadswim/core/names.hpp"
#include "beadswim/core/setting.hpp"
#include "beadswim/mobility/force_moments.hpp"
#include "beadswim/theory/linear_response.hpp"
#include "beadswim/theory/periodic_motion.hpp"
#include "method_rows.hpp"

namespace beadswim {

namespace {

bool is_finite(const Prediction& p) {
  double sum = p.velocity + p.sin_phase_shift + p.uncertainty.value_or(0);
  for (const double d : p.stroke.amplitude) sum += d;
  for (const double delta : p.stroke.phase) sum += delta;
  return std::isfinite(sum);
}

template <PairLaw law>
CollinearMobility pairs_on_line(const CollinearSwimmer& swimmer, const LinePositions& positions) {
  return pairwise_mobility(law, swimmer.radius, positions, swimmer.viscosity);
}

CollinearMobility exact_on_line(const CollinearSwimmer& swimmer, const LinePositions& positions) {
  return exact_mobility(swimmer, positions);
}

/// Adds the mean power of the driving and, if the drag coefficient of the towed swimmer is known, this
/// coefficient and the Lighthill efficiency.
void add_power(const Method& method, const CollinearSwimmer& swimmer, Prediction& prediction) {
  prediction.power = mean_power(swimmer, prediction.stroke);
  std::array<double, 2> arm = swimmer.arm;
  if (prediction.arm_means) std::ranges::copy(*prediction.arm_means, arm.begin());
  const auto drag = towing_drag(method, swimmer, arm);
  if (!drag) return;
  prediction.efficiency = lighthill_efficiency(*drag, prediction.velocity, *prediction.power);
  prediction.settings.emplace_back("towing_drag", *drag);
}

/// Returns the names of the methods that can treat the question, in the order of methods().
std::vector<std::string> methods_for(const Question& question) {
  std::vector<std::string> names;
  for (const Method& method : methods())
    if (obstacle(method, question).empty()) names.push_back(method.name);
  return names;
}

/// Adds the power, and the phase offset of the driving to the stroke, where the prediction does not use a
/// measured stroke.
void add_power_and_offset(const Method& method, const Question& question, Prediction& prediction) {
  if (question.measured_stroke && method.uses_stroke()) return;
  add_power(method, question.line(), prediction);
  if (const double offset = question.line().phase_offset; offset != 0)
    for (double& phase : prediction.stroke.phase)
      phase = std::remainder(phase + offset, 2 * std::numbers::pi);
}

constexpr const char* for_lines_only =
    "it treats three beads on a line with the driving forces of the paper only, in fluid at rest "
    "without half-space";
constexpr const char* for_shapes_only =
    "it treats swimmers of other shapes than three beads on a line; use rpy-box-ode or inertia-corrected";

}  // namespace

const BeadMobility oseen_beads{"Oseen", pairs_on_line<oseen>, [](const ShapedSwimmer& swimmer) {
                                 return pair_mobility(swimmer, oseen_pairs);
                               }};
const BeadMobility rotne_prager_beads{
    "Rotne-Prager", pairs_on_line<rotne_prager>, [](const ShapedSwimmer& swimmer) {
      return swimmer.domain.box ? moment_mobility(swimmer, 0) : pair_mobility(swimmer, rotne_prager_tensor);
    }};
const BeadMobility exact_beads{"exact", exact_on_line, [](const ShapedSwimmer& swimmer) {
                                 return moment_mobility(swimmer, max_moment_order);
                               }};

const std::vector<Method>& methods() {
  using enum Method::Input;
  const BeadMobility *O = &oseen_beads, *R = &rotne_prager_beads, *E = &exact_beads;
  const auto with = [](auto predict, const BeadMobility* beads) {
    return std::bind_front(predict, std::cref(*beads));
  };
  // clang-format off
  static const std::vector<Method> table = [&] {
    std::vector<Method> rows = closed_form_methods();
    rows.insert(rows.end(), {
      {"oseen-perturbation", driving, overlap_obstacle, with(predict_perturbation, O), O, shape_perturbation_obstacle},
      {"rpy-perturbation", driving, overlap_obstacle, with(predict_perturbation, R), R, shape_perturbation_obstacle},
      {"multipole-perturbation", driving, exact_obstacle, with(predict_perturbation, E), E, shape_perturbation_obstacle},
      {"oseen-ode", driving, overlap_obstacle, with(predict_ode, O), O, no_obstacle},
      {"rpy-ode", driving, overlap_obstacle, with(predict_ode, R), R, no_obstacle},
      {"multipole-ode", driving, exact_obstacle, with(predict_ode, E), E, shape_moments_obstacle, true},
      {"rpy-box-perturbation", driving_in_box, box_obstacle, with(predict_box_perturbation, R), R, shape_box_obstacle},
      {"rpy-box-ode", driving_in_box, box_obstacle, with(predict_box_ode, R), R, shape_box_obstacle, true},
      {"multipole-box-perturbation", driving_in_box, nullptr, with(predict_box_perturbation, E), E, shape_box_obstacle},
      {"multipole-box-ode", driving_in_box, nullptr, with(predict_box_ode, E), E, shape_box_obstacle, true},
      {"unsteady-response", driving, inertia_obstacle, predict_unsteady_response, R},
      {"unsteady-multipole", driving, unsteady_multipole_obstacle, predict_unsteady_multipole, E},
      {"inertia-corrected", driving, inertia_corrected_obstacle, predict_inertia_corrected, E},
    });
    return rows;
  }();
  // clang-format on
  return table;
}

const Method& find_method(const std::string& name) {
  const std::vector<Method>& table = methods();
  const auto found =
      std::find_if(table.begin(), table.end(), [&](const Method& row) { return row.name == name; });
  if (found != table.end()) return *found;
  std::vector<std::string> names;
  for (const Method& row : table) names.push_back(row.name);
  throw InputError(Setting::method, format_unknown_name(name, names));
}

std::optional<double> towing_drag(const Method& method, const CollinearSwimmer& swimmer,
                                  const std::array<double, 2>& arm) {
  const LinePositions positions{-arm[0], 0, arm[1]};
  if (!(smallest_gap(swimmer, positions) >= min_exact_gap(swimmer))) return std::nullopt;
  try {
    return method.mobility->on_line(swimmer, positions).value.inverse().sum();
  } catch (const InputError&) {  // beads of very different radii need too many multipoles
    return std::nullopt;
  }
}

std::optional<double> lighthill_efficiency(double drag, double velocity, double power) {
  return power > 0 ? std::optional(drag * velocity * velocity / power) : std::nullopt;
}

std::string obstacle(const Method& method, const Question& question) {
  if (question.is_line())
    return method.obstacle_to_line ? method.obstacle_to_line(question) : for_shapes_only;
  return method.obstacle_to_shape ? method.obstacle_to_shape(question) : for_lines_only;
}

Prediction predict(const Method& method, const Question& question) {
  if (const std::string reason = obstacle(method, question); !reason.empty()) {
    const std::string remedy = question.is_line() || method.obstacle_to_shape
                                   ? ""
                                   : "; methods for this swimmer are " + joined(methods_for(question), ", ");
    throw InputError(method.name, "this method cannot treat this swimmer: " + reason + remedy);
  }
  Prediction prediction = method.predict(question);
  if (!is_finite(prediction)) {
    throw InputError(name_of(Setting::method) + " " + method.name,
                     "this method cannot treat this swimmer: the result is non-finite, because of a pole of "
                     "the formula or of values beyond the range of a double; use another method");
  }
  if (question.is_line()) add_power_and_offset(method, question, prediction);
  prediction.method = method.name;
  return prediction;
}

}  // namespace beadswim
