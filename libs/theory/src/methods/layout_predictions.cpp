#include "beadswim/theory/layout_predictions.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <variant>

#include "beadswim/core/joined.hpp"
#include "beadswim/core/reason_against.hpp"
#include "beadswim/core/setting.hpp"
#include "beadswim/scene/check.hpp"
#include "beadswim/scene/unit_scales.hpp"
#include "beadswim/scene/units.hpp"
#include "beadswim/swimmers/three_bead_swimmer.hpp"
#include "beadswim/theory/methods.hpp"
#include "beadswim/theory/surroundings.hpp"

namespace beadswim {
namespace {

/// A swimmer as theory treats it: three beads that stay on a line, or any other shape.
using TheorySwimmer = std::variant<CollinearSwimmer, ShapedSwimmer>;

/// Returns the parameters of a swimmer that theory needs. Throws InputError, with layout and swimmer in the
/// message, if a spring of a three-bead swimmer has no stiffness.
TheorySwimmer theory_swimmer(const Layout& layout, const Swimmer& swimmer, const std::string& source) {
  const SwimmerType type = layout.resolved_type(swimmer);
  const double viscosity = layout.fluid.dynamic_viscosity();
  const std::optional<ThreeBeadSwimmer> three = three_bead_form(type);
  const bool is_at_rest = !layout.domain.half_space && layout.flow.is_zero();
  if (!three || !stays_on_a_line(*three, swimmer.axis) || !is_at_rest) {
    ShapedSwimmer shape{.type = type,
                        .orientation = swimmer.orientation(),
                        .viscosity = viscosity,
                        .half_space = layout.domain.half_space,
                        .flow = layout.flow};
    if (shape.is_held())
      shape.place =
          columns_of_beads(rest_positions(type, swimmer.position, shape.orientation)).rowwise().mean();
    if (const auto& half_space = layout.domain.half_space)  // nothing changes along the wall
      shape.place = half_space->height(shape.place) * Vec3::Unit(half_space->axis);
    return shape;
  }
  try {
    return collinear_swimmer(*three, swimmer.axis, viscosity);
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: swimmer {}", source, swimmer.id), error.what());
  }
}

const Swimmer& find_swimmer(const Layout& layout, int id, const std::string& source) {
  const auto found = std::ranges::find(layout.swimmers, id, &Swimmer::id);
  if (found != layout.swimmers.end()) return *found;
  const auto [lowest, highest] = std::ranges::minmax_element(layout.swimmers, {}, &Swimmer::id);
  throw InputError(Setting::swimmer,
                   fmt::format("the layout {} has no swimmer with the id {}; the ids range from {} to {}",
                               source, id, lowest->id, highest->id));
}

/// Returns the first swimmer of the layout. Throws InputError if other swimmers have other parameters,
/// because one prediction would then not be valid for all.
const Swimmer& find_common_swimmer(const Layout& layout, const std::string& source) {
  const Swimmer& first = layout.swimmers.front();
  const TheorySwimmer common = theory_swimmer(layout, first, source);
  for (const Swimmer& other : layout.swimmers) {
    if (theory_swimmer(layout, other, source) == common) continue;
    throw InputError(
        source, fmt::format("swimmers {} and {} differ, but a prediction is for one swimmer; name the "
                            "swimmer with {} ID{}",
                            first.id, other.id, Setting::swimmer,
                            layout.domain.box ? ", or make a smaller cell with beadswim-layout reduce" : ""));
  }
  return first;
}

/// Returns the measured stroke. Throws InputError if units or driving period of the run differ from those of
/// the layout.
Stroke stroke_for(const Layout& layout, const CollinearSwimmer& swimmer, const MeasuredStroke& measured,
                  const UnitScales& units) {
  const std::string where = fmt::format("{} {}", Setting::stroke_record, measured.source);
  if (!same_units(layout.units, measured.units)) {
    throw InputError(
        where, "the run's units of length and time differ from the layout's; give a run of the same layout");
  }
  constexpr double period_tolerance = 1e-9;  // relative; allows for rounding errors
  const double period = swimmer.period * units.time;
  if (std::abs(measured.period / period - 1) > period_tolerance) {
    throw InputError(
        where,
        fmt::format("the driving period is {} in the run but {} in the layout; give a run of the same layout",
                    measured.period, period));
  }
  Stroke stroke = measured.stroke;
  for (double& amplitude : stroke.amplitude) amplitude /= units.length;
  return stroke;
}

// lacks_input() returns true if the method needs a measured stroke, or a box, that the question does not
// contain, or three beads on a line. A request for all methods omits such a method without a message.
bool lacks_input(const Method& method, const ShapeQuestion&) {
  return method.predict_shape == nullptr;
}
bool lacks_input(const Method& method, const Question& question) {
  const bool lacks_stroke = method.input == Method::Input::stroke && !question.measured_stroke;
  const bool lacks_box =
      method.input == Method::Input::driving_in_box && !question.box && question.box_obstacle.empty();
  return lacks_stroke || lacks_box;
}

/// Adds the predictions of all methods that can treat the question, a Question or a ShapeQuestion.
void predict_by_all(const auto& question, LayoutPredictions& predicted) {
  for (const Method& method : methods()) {
    if (lacks_input(method, question)) continue;
    std::optional<std::string> reason;
    if constexpr (std::same_as<decltype(question), const Question&>) reason = method.obstacle(question);
    if (!reason) reason = reason_against([&] { predicted.predictions.push_back(predict(method, question)); });
    if (!reason->empty()) predicted.left_out.push_back({method.name, *reason});
  }
  if (predicted.predictions.empty()) {
    throw InputError(fmt::format("{} {}", Setting::method, all_methods),
                     fmt::format("no method can predict this swimmer; {}, for example, cannot because {}",
                                 predicted.left_out.front().method, predicted.left_out.front().reason));
  }
}

/// Adds the predictions of the named methods.
void predict_by(const std::vector<std::string>& names, const auto& question, LayoutPredictions& predicted) {
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
                     fmt::format("no method can use the measured stroke; {}, for example, cannot because {}",
                                 left_out.method, left_out.reason));
  }
  std::vector<std::string> users;
  for (const Method& method : methods())
    if (method.uses_stroke()) users.push_back(method.name);
  throw InputError(Setting::stroke_record,
                   fmt::format("none of the named methods uses a measured stroke; add one of {} to {}",
                               joined(users, ", "), Setting::method));
}

void predict_line(const CollinearSwimmer& line, const Layout& layout, const Swimmer& swimmer,
                  const PredictionRequest& request, const UnitScales& units, LayoutPredictions& predicted) {
  const Surroundings surroundings = surroundings_of(layout, swimmer);
  Question question = with_exact_reference({.swimmer = line,
                                            .fluid_density = layout.fluid.density,
                                            .box = surroundings.box,
                                            .box_obstacle = surroundings.obstacle,
                                            .units = units});
  if (request.measured)
    question.measured_stroke = stroke_for(layout, question.swimmer, *request.measured, units);
  if (request.methods == std::vector<std::string>{all_methods})
    question = with_open_space_motion(std::move(question));
  predict_by(request.methods, question, predicted);
  check_stroke_is_used(predicted, question);
  predicted.warnings = warnings(question, request.tolerance);
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
  if (auto& means = prediction.arm_means)
    for (double& mean : *means) mean *= units.length;
  for (auto& [name, value] : prediction.settings)
    if (double* number = std::get_if<double>(&value)) *number *= unit_of(name, units);
}

}  // namespace

LayoutPredictions predict_layout(const Layout& in_layout_units, const std::string& source,
                                 const PredictionRequest& request) {
  const UnitScales units = natural_units(in_layout_units);
  const Layout layout = in_units(in_layout_units, units);
  const Swimmer& swimmer =
      request.swimmer ? find_swimmer(layout, *request.swimmer, source) : find_common_swimmer(layout, source);
  LayoutPredictions predicted{.units = layout.units, .swimmer = swimmer.id};
  const TheorySwimmer treated = theory_swimmer(layout, swimmer, source);
  if (const auto* line = std::get_if<CollinearSwimmer>(&treated)) {
    predict_line(*line, layout, swimmer, request, units, predicted);
  } else if (request.measured) {
    throw InputError(
        Setting::stroke_record,
        "no method can use a measured stroke for this swimmer; such methods are for three beads on a "
        "line in fluid at rest");
  } else {
    const ShapeQuestion question{std::get<ShapedSwimmer>(treated), layout.fluid.density, units};
    predict_by(request.methods, question, predicted);
  }
  for (Prediction& prediction : predicted.predictions) to_layout_units(prediction, units);
  if (std::string warning = warning_of_fixed_forces(layout); !warning.empty())
    predicted.warnings.push_back(std::move(warning));
  return predicted;
}

}  // namespace beadswim
