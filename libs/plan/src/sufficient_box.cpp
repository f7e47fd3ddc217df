#include "beadswim/plan/sufficient_box.hpp"

#include <algorithm>
#include <cmath>

#include "beadswim/plan/model_errors.hpp"
#include "beadswim/core/reason_against.hpp"
#include "swimmer_in_box.hpp"

namespace beadswim {
namespace {

Vec3 box_around(const CollinearSwimmer& swimmer, double free_length) {
  const double radius = *std::ranges::min_element(swimmer.radius);
  const auto rounded_up = [&](double edge) { return radius * std::ceil(edge / radius - 1e-9); };
  return {rounded_up(swimmer_length(swimmer) + free_length), rounded_up(free_length),
          rounded_up(free_length)};
}

}  // namespace

std::optional<SufficientBox> sufficient_box(const Question& question, double tolerance) {
  const BestPrediction reference = best_prediction(question);
  const CollinearSwimmer& swimmer = question.swimmer;
  const double length = swimmer.arm[0] + swimmer.arm[1];
  constexpr double factor = 1.2, longest = 20;
  for (double free_length = 0.5 * length; free_length < longest * length; free_length *= factor) {
    const Vec3 lengths = box_around(swimmer, free_length);
    Question boxed = question;
    boxed.box = box_place_at_centre(lengths);
    double change = INFINITY;  // stays infinite if the box is too narrow for theory
    reason_against([&] { change = difference(best_prediction(boxed), reference).largest(); });
    if (change <= tolerance) return SufficientBox{.lengths = lengths, .change = change};
  }
  return std::nullopt;
}

}  // namespace beadswim
