#include <algorithm>
#include <cmath>

#include "beadswim/core/error.hpp"
#include "beadswim/core/joined.hpp"
#include "beadswim/study/optimisation.hpp"

namespace beadswim {
namespace {

/// Appends the violation of each side of a constraint: distance of the value beyond the bound, relative to
/// the bound, or to `typical` if the bound is 0. Negative within the range.
void append_violations(const Constraint& constraint, double value, double typical,
                       std::vector<double>& violations) {
  const auto unit = [typical](double bound) {
    return bound != 0 ? std::abs(bound) : typical != 0 ? std::abs(typical) : 1;
  };
  if (std::isfinite(constraint.low)) violations.push_back((constraint.low - value) / unit(constraint.low));
  if (std::isfinite(constraint.high)) violations.push_back((value - constraint.high) / unit(constraint.high));
}

}  // namespace

double FreeValue::at(double coordinate) const {
  if (coordinate <= 0) return from;
  if (coordinate >= 1) return to;
  return is_logarithmic() ? from * std::pow(to / from, coordinate) : from + coordinate * (to - from);
}

StudyPoint study_point(const std::vector<FreeValue>& free, const Position& position) {
  StudyPoint point;
  for (std::size_t i = 0; i < free.size(); ++i)
    for (const std::string& name : free[i].names) point.emplace_back(name, free[i].at(position[i]));
  return point;
}

std::vector<std::string> outcome_names() {
  std::vector<std::string> names;
  for (const ResultRow& row : result_rows)
    if (!row.is_per_arm) names.emplace_back(row.name);
  return names;
}

std::vector<ResultQuantity> Problem::stated_outcomes() const {
  std::vector<ResultQuantity> stated{ResultQuantity::velocity, ResultQuantity::angular_velocity,
                                     ResultQuantity::efficiency, ResultQuantity::power, ResultQuantity::gap};
  const auto add = [&](ResultQuantity outcome) {
    if (std::ranges::find(stated, outcome) == stated.end()) stated.push_back(outcome);
  };
  add(objective);
  for (const Constraint& constraint : constraints) add(constraint.outcome);
  return stated;
}

int Problem::num_inequalities() const {
  int sides = 0;
  for (const Constraint& constraint : constraints)
    sides += std::isfinite(constraint.low) + std::isfinite(constraint.high);
  return sides;
}

Trial Problem::trial_of(const Outcomes& outcomes, const Outcomes& typical) const {
  Trial trial;
  const double value = outcomes.at(objective).value;
  trial.value = is_maximised ? -value : value;
  for (const Constraint& constraint : constraints)
    append_violations(constraint, outcomes.at(constraint.outcome).value, typical.at(constraint.outcome).value,
                      trial.violations);
  return trial;
}

void Problem::require_outcomes(const Outcomes& outcomes, const std::string& evaluator) const {
  std::vector<std::string> given;
  for (const ResultQuantity outcome : stated_outcomes())
    if (outcomes.contains(outcome)) given.emplace_back(to_text(outcome));
  const auto require = [&](ResultQuantity outcome, Setting setting) {
    if (outcomes.contains(outcome)) return;
    if (outcome == ResultQuantity::effective_diffusion &&
        outcomes.contains(ResultQuantity::rotational_diffusion))
      throw InputError(setting,
                       "runs by {} are shorter than five persistence times, from which on they give {}; "
                       "increase {}",
                       evaluator, to_text(outcome), Setting::cycles);
    throw InputError(setting, "{} gives no {} for this layout; it gives {}", evaluator, to_text(outcome),
                     joined(given, ", "));
  };
  require(objective, is_maximised ? Setting::maximise : Setting::minimise);
  for (const Constraint& constraint : constraints) require(constraint.outcome, Setting::limit);
}

}  // namespace beadswim
