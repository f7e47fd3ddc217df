#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "beadswim/theory/prediction.hpp"
#include "beadswim/theory/question.hpp"

namespace beadswim {

struct BeadMobility;

/// A method of prediction: a row of the table that methods() returns.
struct Method {
  std::string name;
  /// Input that the method uses in addition to the swimmer.
  enum class Input { driving, driving_or_stroke, stroke, driving_in_box } input;
  /// Returns the reason why the method cannot treat three beads on a line, and a remedy; empty if it can.
  /// nullptr: the method treats other shapes only.
  std::string (*obstacle_to_line)(const Question& question);
  /// Returns the prediction. Requires a question without obstacle. Throws InputError if the calculation
  /// fails.
  std::function<Prediction(const Question& question)> predict;
  const BeadMobility*
      mobility;  ///< steady mobility in open space, by which the swimmer is towed for its efficiency
  /// The same for a swimmer of another shape; nullptr: the method treats three beads on a line only.
  std::string (*obstacle_to_shape)(const Question& question) = nullptr;
  bool is_slow_for_shapes = false;  ///< a request for all methods leaves it out, as it can take minutes

  /// Returns whether the method uses a measured stroke.
  bool uses_stroke() const { return input == Input::stroke || input == Input::driving_or_stroke; }
};

/// Returns all methods, in the order in which they are listed for users.
const std::vector<Method>& methods();

/// Returns the method of that name. Throws InputError if there is none; the message contains the most similar
/// name and all names.
const Method& find_method(const std::string& name);

/// Returns the drag coefficient of the swimmer with these arm lengths [length] that is towed along its axis
/// in open space, with the steady mobility of the method [mass/time]. Uses only radii and viscosity of
/// `swimmer`. Returns nullopt if beads touch or nearly touch, or if their radii differ too much for the
/// method.
std::optional<double> towing_drag(const Method& method, const CollinearSwimmer& swimmer,
                                  const std::array<double, 2>& arm);

/// Returns the Lighthill efficiency D v^2/P; nullopt if the power P is not positive. `drag`: D [mass/time];
/// `velocity`: v [length/time]; `power`: P [mass length^2/time^3].
std::optional<double> lighthill_efficiency(double drag, double velocity, double power);

/// Returns the reason why the method cannot treat the question, and a remedy; empty if it can treat it.
std::string obstacle(const Method& method, const Question& question);

/// Returns the method's prediction, with the mean power P of the driving and the Lighthill efficiency D
/// V^2/P. V is the velocity along the axis; the drag coefficient D is that of the swimmer with its mean arm
/// lengths, or rest lengths if the method does not predict them (towing_drag), and of another swimmer that
/// with its mean shape. Throws InputError with the reason if the method cannot treat the question or if its
/// result is not finite.
Prediction predict(const Method& method, const Question& question);

}  // namespace beadswim
