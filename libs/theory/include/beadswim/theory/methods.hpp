#pragma once

#include <optional>
#include <string>
#include <vector>

#include "beadswim/theory/prediction.hpp"
#include "beadswim/theory/question.hpp"

namespace beadswim {

/// A method of prediction: a row of the table below.
struct Method {
  std::string name;
  /// What it takes beside the swimmer: the driving, a measured stroke, or the driving in a box.
  enum class Input { driving, driving_or_stroke, stroke, driving_in_box } input;
  /// Why the method cannot treat the question, and what could; none if it can.
  std::optional<std::string> (*obstacle)(const Question& question);
  /// Needs a question without obstacle. Throws InputError where it turns out on the way that it cannot.
  Prediction (*predict)(const Question& question);

  /// Whether it makes use of a measured stroke.
  bool uses_stroke() const { return input == Input::stroke || input == Input::driving_or_stroke; }
};

/// All methods, in the order in which they are shown.
const std::vector<Method>& methods();

/// The method of that name. Throws InputError naming the nearest name and all names.
const Method& find_method(const std::string& name);

/// What the method predicts. Throws InputError with the reason if it cannot treat the question.
Prediction predict(const Method& method, const Question& question);

}  // namespace beadswim
