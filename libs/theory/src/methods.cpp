#include "beadswim/theory/methods.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "beadswim/core/error.hpp"
#include "beadswim/core/nearest_name.hpp"
#include "method_rows.hpp"

namespace beadswim {

const std::vector<Method>& methods() {
  static const std::vector<Method> table{
      {"oseen-force-closed", oseen_force_obstacle, predict_oseen_force},
      {"oseen-stroke-closed", oseen_stroke_obstacle, predict_oseen_stroke},
      {"oseen-perturbation", perturbation_obstacle, predict_oseen_perturbation},
      {"rpy-perturbation", perturbation_obstacle, predict_rpy_perturbation},
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
  throw InputError("--method", fmt::format("unknown method '{}'; did you mean '{}'? Methods: {}", name,
                                           nearest_name(name, names), fmt::join(names, ", ")));
}

Prediction predict(const Method& method, const Question& question) {
  if (const auto obstacle = method.obstacle(question)) {
    throw InputError("--method " + method.name, "cannot treat this swimmer: " + *obstacle);
  }
  Prediction prediction = method.predict(question);
  prediction.method = method.name;
  return prediction;
}

}  // namespace beadswim
