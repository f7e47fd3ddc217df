#include "beadswim/theory/layout_predictions.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "beadswim/core/joined.hpp"
#include "beadswim/core/reason_against.hpp"
#include "beadswim/core/setting.hpp"
#include "beadswim/scene/check.hpp"
#include "beadswim/scene/unit_scales.hpp"
#include "beadswim/swimmers/three_bead_swimmer.hpp"
#include "beadswim/theory/methods.hpp"

namespace beadswim {
namespace {

/// Returns the mean position of the beads at rest [length].
Vec3 mean_position(const SwimmerType& type, const Swimmer& swimmer) {
  return columns_of_beads(rest_positions(type, swimmer.position, swimmer.orientation())).rowwise().mean();
}

/// Returns the parameters of a swimmer that theory needs.
TheorySwimmer theory_swimmer(const Layout& layout, const Swimmer& swimmer) {
  const SwimmerType type = layout.resolved_type(swimmer);
  const double viscosity = layout.fluid.dynamic_viscosity();
  const std::optional<ThreeBeadSwimmer> three = three_bead_form(type);
  const bool is_at_rest = !layout.domain.half_space && layout.flow.is_zero();
  if (three && stays_on_a_line(*three, swimmer.axis) && is_at_rest)
    return collinear_swimmer(*three, swimmer.axis, viscosity);
  ShapedSwimmer shape{.type = type,
                      .orientation = swimmer.orientation(),
                      .viscosity = viscosity,
                      .domain = {.box = {}, .half_space = layout.domain.half_space},
                      .flow = layout.flow};
  if (shape.is_held()) shape.place = mean_position(type, swimmer);
  if (const auto& half_space = layout.domain.half_space)  // nothing changes along the wall
    shape.place = half_space->height(shape.place) * Vec3::Unit(half_space->axis);
  return shape;
}

const Swimmer& find_swimmer(const Layout& layout, int id, const std::string& source) {
  const auto found = std::ranges::find(layout.swimmers, id, &Swimmer::id);
  if (found != layout.swimmers.end()) return *found;
  const auto [lowest, highest] = std::ranges::minmax_element(layout.swimmers, {}, &Swimmer::id);
  throw InputError(Setting::swimmer,
                   "the layout {} has no swimmer with the id {}; the ids range from {} to {}", source, id,
                   lowest->id, highest->id);
}

/// Returns the first swimmer of the layout. Throws InputError if other swimmers have other parameters,
/// because one prediction would then not be valid for all.
const Swimmer& find_common_swimmer(const Layout& layout, const std::string& source) {
  const Swimmer& first = layout.swimmers.front();
  const TheorySwimmer common = theory_swimmer(layout, first);
  for (const Swimmer& other : layout.swimmers) {
    if (theory_swimmer(layout, other) == common) continue;
    throw InputError(
        source,
        "swimmers {} and {} differ, but a prediction is for one swimmer; name the swimmer with {} ID{}",
        first.id, other.id, Setting::swimmer,
        layout.domain.box ? ", or make a smaller cell with beadswim-layout reduce" : "");
  }
  return first;
}

/// Returns the measured stroke. Throws InputError if units or driving period of the run differ from those of
/// the layout, or if no method can use a stroke.
Stroke stroke_for(const Layout& layout, const Question& question, const MeasuredStroke& measured) {
  if (!question.is_line())
    throw InputError(
        Setting::stroke_record,
        "no method can use a measured stroke for this swimmer; such methods are for three beads on a "
        "line in fluid at rest");
  const std::string where = fmt::format("{} {}", Setting::stroke_record, measured.source);
  if (layout.units != measured.units) {
    throw InputError(
        where, "the run's units of length and time differ from the layout's; give a run of the same layout");
  }
  constexpr double period_tolerance = 1e-9;  // relative; allows for rounding errors
  const double period = question.line().period * question.units().time;
  if (std::abs(measured.period / period - 1) > period_tolerance) {
    throw InputError(
        where, "the driving period is {} in the run but {} in the layout; give a run of the same layout",
        measured.period, period);
  }
  Stroke stroke = measured.stroke;
  for (double& amplitude : stroke.amplitude) amplitude /= question.units().length;
  return stroke;
}

/// Returns true if the method needs a measured stroke, or a box, that the question does not contain, or
/// another kind of swimmer, or if it is slow. A request for all methods omits such a method without a
/// message.
bool lacks_input(const Method& method, const Question& question) {
  if (!question.is_line() && method.is_slow_for_shapes) return true;
  if ((question.is_line() ? method.obstacle_to_line : method.obstacle_to_shape) == nullptr) return true;
  const bool lacks_stroke = method.input == Method::Input::stroke && !question.measured_stroke;
  const bool lacks_box = method.input == Method::Input::driving_in_box && !question.surroundings.box &&
                         question.surroundings.obstacle.empty();
  return lacks_stroke || lacks_box;
}

/// Adds the predictions of all methods that can treat the question.
void predict_by_all(const Question& question, LayoutPredictions& predicted) {
  for (const Method& method : methods()) {
    if (lacks_input(method, question)) continue;
    std::string reason = obstacle(method, question);
    if (reason.empty())
      reason = reason_against([&] { predicted.predictions.push_back(predict(method, question)); });
    if (!reason.empty()) predicted.left_out.push_back({method.name, reason});
  }
  if (predicted.predictions.empty()) {
    throw InputError(fmt::format("{} {}", Setting::method, all_methods),
                     "no method can predict this swimmer; {}, for example, cannot because {}",
                     predicted.left_out.front().method, predicted.left_out.front().reason);
  }
}

/// Adds the predictions of the named methods.
void predict_by(const std::vector<std::string>& names, const Question& question,
                LayoutPredictions& predicted) {
  if (names == std::vector<std::string>{all_methods}) return predict_by_all(question, predicted);
  for (const std::string& name : names) {
    if (name == all_methods)
      throw InputError(Setting::method,
                       "\"all\" stands for all methods and cannot be combined with names of methods; leave "
                       "out \"all\" or the names");
    predicted.predictions.push_back(predict(find_method(name), question));
  }
}

/// Throws InputError if a measured stroke was given, but no method of the predictions uses it.
void check_stroke_is_used(const LayoutPredictions& predicted, const Question& question) {
  if (!question.measured_stroke) return;
  const auto uses_it = [](const std::string& method) { return find_method(method).uses_stroke(); };
  if (std::ranges::any_of(predicted.predictions, uses_it, &Prediction::method)) return;
  for (const LeftOutMethod& left_out : predicted.left_out) {
    if (!uses_it(left_out.method)) continue;
    throw InputError(Setting::stroke_record,
                     "no method can use the measured stroke; {}, for example, cannot because {}",
                     left_out.method, left_out.reason);
  }
  std::vector<std::string> users;
  for (const Method& method : methods())
    if (method.uses_stroke()) users.push_back(method.name);
  throw InputError(Setting::stroke_record,
                   "none of the named methods uses a measured stroke; add one of {} to {}",
                   joined(users, ", "), Setting::method);
}

/// Returns the unit of a setting of a prediction.
double unit_of(const std::string& setting, const UnitScales& units) {
  if (setting == "period") return units.time;
  if (setting == "amplitude") return units.force();
  if (setting == "towing_drag") return units.damping();
  const bool is_velocity = setting == "numerical_error" ||
                           (setting.starts_with("velocity_") && setting != "velocity_over_unbounded");
  return is_velocity ? units.velocity() : 1;
}

void to_layout_units(Prediction& prediction, const UnitScales& units) {
  prediction.velocity *= units.velocity();
  if (auto& velocity = prediction.velocity_vector) *velocity *= units.velocity();
  if (auto& angular_velocity = prediction.angular_velocity) *angular_velocity /= units.time;
  for (double& amplitude : prediction.stroke.amplitude) amplitude *= units.length;
  if (auto& power = prediction.power) *power *= units.power();
  if (auto& dipole = prediction.dipole) {
    dipole->axial *= units.energy();
    for (double& component : dipole->tensor) component *= units.energy();
  }
  if (auto& means = prediction.arm_means)
    for (double& mean : *means) mean *= units.length;
  for (auto& [name, value] : prediction.settings)
    if (double* number = std::get_if<double>(&value)) *number *= unit_of(name, units);
}

}  // namespace

bool are_predicted_alike(const Layout& layout, int a, int b) {
  const auto first = std::ranges::find(layout.swimmers, a, &Swimmer::id);
  const auto second = std::ranges::find(layout.swimmers, b, &Swimmer::id);
  if (first == layout.swimmers.end() || second == layout.swimmers.end()) return false;
  return theory_swimmer(layout, *first) == theory_swimmer(layout, *second);
}

LayoutPredictions predict_layout(const Layout& in_layout_units, const std::string& source,
                                 const PredictionRequest& request) {
  const UnitScales units = natural_units(in_layout_units);
  const Layout layout = in_units(in_layout_units, units);
  const Swimmer& swimmer =
      request.swimmer ? find_swimmer(layout, *request.swimmer, source) : find_common_swimmer(layout, source);
  LayoutPredictions predicted{.units = layout.units, .swimmer = swimmer.id};
  Question question(theory_swimmer(layout, swimmer), layout.fluid.density, units);
  const SwimmerType type = layout.resolved_type(swimmer);
  question.surroundings = question.is_line() ? surroundings_of(layout, swimmer)
                                             : surroundings_of_shape(layout, mean_position(type, swimmer),
                                                                     type.driving.net_force);
  if (request.measured) question.measured_stroke = stroke_for(layout, question, *request.measured);
  predict_by(request.methods, question, predicted);
  if (question.is_line()) {
    check_stroke_is_used(predicted, question);
    predicted.warnings = warnings(question, request.tolerance);
  }
  for (Prediction& prediction : predicted.predictions) to_layout_units(prediction, units);
  if (in_layout_units.fluid.thermal_energy > 0)
    for (Prediction& prediction : predicted.predictions)
      prediction.thermal = predicted_diffusion(
          in_layout_units.resolved_type(find_swimmer(in_layout_units, swimmer.id, source)),
          in_layout_units.fluid, prediction.velocity, prediction.stroke,
          prediction.arm_means.value_or(std::vector<double>{}));
  if (std::string warning = warning_of_fixed_forces(layout); !warning.empty())
    predicted.warnings.push_back(std::move(warning));
  if (layout.fluid.thermal_energy > 0)
    predicted.warnings.emplace_back(
        "predicted motions leave out the thermal noise of the layout, whose diffusion is stated with them");
  return predicted;
}

}  // namespace beadswim
