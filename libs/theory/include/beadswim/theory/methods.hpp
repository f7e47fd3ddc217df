#pragma once

#include <optional>
#include <string>
#include <vector>

#include "beadswim/theory/collinear_swimmer.hpp"
#include "beadswim/theory/prediction.hpp"

namespace beadswim {

/// What a method is asked: a swimmer, and the stroke that it was measured to have, if any.
struct Question {
  CollinearSwimmer swimmer;
  double fluid_density = 0;  ///< rho [mass/length^3], to say how far inertia reaches
  std::optional<Stroke> measured_stroke;
};

/// A method of prediction: a row of the table below.
struct Method {
  std::string name;
  /// Why the method cannot treat the question, and what could; none if it can.
  std::optional<std::string> (*obstacle)(const Question& question);
  /// Needs a question without obstacle.
  Prediction (*predict)(const Question& question);
};

/// All methods, in the order in which they are shown.
const std::vector<Method>& methods();

/// The method of that name. Throws InputError naming the nearest name and all names.
const Method& find_method(const std::string& name);

/// What the method predicts. Throws InputError with the reason if it cannot treat the question.
Prediction predict(const Method& method, const Question& question);

}  // namespace beadswim
