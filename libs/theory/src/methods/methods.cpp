#include "beadswim/theory/methods.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "beadswim/core/error.hpp"
#include "beadswim/core/nearest_name.hpp"
#include "beadswim/core/setting.hpp"
#include "method_rows.hpp"

namespace beadswim {

namespace {

bool is_finite(const Prediction& p) {
  const auto& [d, delta] = p.stroke;
  return std::isfinite(p.velocity + d[0] + d[1] + delta[0] + delta[1] + p.sin_phase_shift +
                       p.uncertainty.value_or(0));
}

}  // namespace

const std::vector<Method>& methods() {
  using enum Method::Input;
  static const std::vector<Method> table{
      {"oseen-force-closed", driving, equal_parts_obstacle, predict_oseen_force},
      {"oseen-stroke-closed", driving_or_stroke, oseen_stroke_obstacle, predict_oseen_stroke},
      {"oseen-ratio-printed", driving, equal_parts_obstacle, predict_oseen_ratio_printed},
      {"oseen-ratio-repaired", driving_or_stroke, equal_shape_obstacle, predict_oseen_ratio_repaired},
      {"rpy-force-printed", driving, rpy_force_printed_obstacle, predict_rpy_force_printed},
      {"rpy-force-repaired", driving, equal_parts_obstacle, predict_rpy_force_repaired},
      {"rpy-stroke-printed", driving_or_stroke, equal_shape_obstacle, predict_rpy_stroke_printed},
      {"rpy-equal-weight", driving_or_stroke, equal_shape_obstacle, predict_rpy_equal_weight},
      {"multipole-stroke", stroke, measured_stroke_obstacle, predict_multipole_stroke},
      {"oseen-perturbation", driving, overlap_obstacle, predict_oseen_perturbation},
      {"rpy-perturbation", driving, overlap_obstacle, predict_rpy_perturbation},
      {"multipole-perturbation", driving, exact_obstacle, predict_multipole_perturbation},
      {"oseen-ode", driving, overlap_obstacle, predict_oseen_ode},
      {"rpy-ode", driving, overlap_obstacle, predict_rpy_ode},
      {"multipole-ode", driving, exact_obstacle, predict_multipole_ode},
      {"rpy-box-perturbation", driving_in_box, box_obstacle, predict_rpy_box_perturbation},
      {"rpy-box-ode", driving_in_box, box_obstacle, predict_rpy_box_ode},
      {"unsteady-response", driving, inertia_obstacle, predict_unsteady_response},
      {"unsteady-multipole", driving, unsteady_multipole_obstacle, predict_unsteady_multipole},
      {"inertia-corrected", driving, inertia_corrected_obstacle, predict_inertia_corrected},
  };
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

Prediction predict(const Method& method, const Question& question) {
  if (const auto obstacle = method.obstacle(question)) {
    throw InputError(method.name, "this method cannot treat this swimmer: " + *obstacle);
  }
  Prediction prediction = method.predict(question);
  const double offset = question.swimmer.phase_offset;
  if (!(question.measured_stroke && method.uses_stroke()) && offset != 0) {
    for (double& phase : prediction.stroke.phase)
      phase = std::remainder(phase + offset, 2 * std::numbers::pi);
  }
  if (!is_finite(prediction)) {
    throw InputError(name_of(Setting::method) + " " + method.name,
                     "this method cannot treat this swimmer: the result is non-finite, because of a pole of "
                     "the formula or of values beyond the range of a double; use another method");
  }
  prediction.method = method.name;
  return prediction;
}

}  // namespace beadswim
