#pragma once

#include <optional>
#include <string>
#include <vector>

#include "beadswim/theory/prediction.hpp"
#include "beadswim/theory/question.hpp"

namespace beadswim {

/// A method of prediction: a row of the table that methods() returns.
struct Method {
  std::string name;
  /// Input that the method uses in addition to the swimmer.
  enum class Input { driving, driving_or_stroke, stroke, driving_in_box } input;
  /// Returns why the method cannot treat the question, and the remedy; nullopt if it can.
  std::optional<std::string> (*obstacle)(const Question& question);
  /// Returns the prediction. Requires a question without obstacle. Throws InputError on failure.
  Prediction (*predict)(const Question& question);

  /// Returns whether the method uses a measured stroke.
  bool uses_stroke() const { return input == Input::stroke || input == Input::driving_or_stroke; }
};

/// Returns all methods, in the order in which they are listed for users.
const std::vector<Method>& methods();

/// Returns the method of that name. Throws InputError, which names the most similar name and all names.
const Method& find_method(const std::string& name);

/// Returns the method's prediction. Throws InputError with the reason if the method cannot treat the question
/// or if its result is not finite.
Prediction predict(const Method& method, const Question& question);

}  // namespace beadswim
