#include "beadswim/plan/sufficient_box.hpp"

#include <algorithm>
#include <cmath>

#include "beadswim/core/error.hpp"
#include "beadswim/plan/model_errors.hpp"

namespace beadswim {
namespace {

double change_between(const BestKnown& a, const BestKnown& b) {
  double change = b.swims ? std::abs(a.velocity / b.velocity - 1) : 0;
  for (int arm = 0; arm < 2; ++arm) {
    if (b.arm_amplitudes[arm] > 0)
      change = std::max(change, std::abs(a.arm_amplitudes[arm] / b.arm_amplitudes[arm] - 1));
  }
  return change;
}

Vec3 box_around(const CollinearSwimmer& swimmer, double free_length) {
  const double radius = *std::ranges::min_element(swimmer.radius);
  const double length = swimmer.radius[0] + swimmer.arm[0] + swimmer.arm[1] + swimmer.radius[2];
  const auto whole = [&](double edge) { return radius * std::ceil(edge / radius - 1e-9); };
  return {whole(length + free_length), whole(free_length), whole(free_length)};
}

}  // namespace

std::optional<SufficientBox> sufficient_box(const Question& question, double tolerance) {
  const BestKnown here = best_known(question);
  const CollinearSwimmer& swimmer = question.swimmer;
  const double length = swimmer.arm[0] + swimmer.arm[1];
  constexpr double factor = 1.2, longest = 20;
  for (double free_length = 0.5 * length; free_length < longest * length; free_length *= factor) {
    const Vec3 lengths = box_around(swimmer, free_length);
    Question boxed = question;
    boxed.box = BoxPlace{.box = {.lengths = {lengths[0], lengths[1], lengths[2]}, .free_slip = {}},
                         .middle_bead = {lengths[0] / 2, lengths[1] / 2, lengths[2] / 2}};
    try {
      const double change = change_between(best_known(boxed), here);
      if (change <= tolerance) return SufficientBox{.lengths = lengths, .change = change};
    } catch (const InputError&) {  // too narrow for theory: a larger one
    } catch (const SolverError&) {
    }
  }
  return std::nullopt;
}

}  // namespace beadswim
