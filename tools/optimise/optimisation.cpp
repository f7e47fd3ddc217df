#include "optimisation.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <random>

#include "beadswim/core/error.hpp"
#include "beadswim/study/stream.hpp"

namespace beadswim {
namespace {

constexpr double flat_share = 0.01;  // loss of the objective in the ranges that are reported

void say(const std::string& text) {
  print_to_stderr(fmt::format("{}: {}\n", optimise_name, text));
}

/// Adds the outcomes `stated` to a line of the trace; those that are missing or not finite are null.
void append_outcomes(const Outcomes& outcomes, const std::vector<ResultQuantity>& stated, Json& line) {
  for (const ResultQuantity outcome : stated) {
    const auto found = outcomes.find(outcome);
    const bool is_known = found != outcomes.end() && std::isfinite(found->second.value);
    line[to_text(outcome)] = is_known ? Json(found->second.value) : Json();
  }
}

Json study_of(const StudyPoint& point) {
  Json study = Json::object();
  for (const auto& [name, value] : point) study[name] = value;
  return study;
}

/// Removes the results of an earlier search for the same values from the study of a layout.
void remove_earlier_results(const std::vector<FreeValue>& free, Json& layout) {
  if (!layout.contains("study")) return;
  Json& study = layout["study"];
  for (const FreeValue& value : free)
    for (const std::string& name : value.names)
      for (const char* end : {"", "_from", "_to"}) study.erase(name + end);
  const Json former = study;
  for (const auto& [key, value] : former.items())
    for (const std::string& name : outcome_names())
      if (key == name || key.starts_with(name + "_by_")) study.erase(key);
  if (study.empty()) layout.erase("study");
}

/// Returns positions for first trials: the centre, two corners, and random positions, always the same.
std::vector<Position> first_positions(std::size_t dimensions) {
  std::vector<Position> positions;
  for (const double coordinate : {0.5, 0.0, 1.0}) positions.emplace_back(dimensions, coordinate);
  std::mt19937 random;  // with its default seed
  while (positions.size() < 64) {
    Position& position = positions.emplace_back();
    for (std::size_t i = 0; i < dimensions; ++i) position.push_back(random() * 0x1p-32);
  }
  return positions;
}

}  // namespace

Optimisation::Optimisation(StreamMember member, const Problem& problem, const std::vector<FreeValue>& free,
                           const NamedEvaluator& by, const OpenFile& trace)
    : member_(std::move(member)),
      layout_(parse_json(member_.text, member_.source)),  // unchanged: absent rest lengths stay absent
      problem_(problem),
      free_(free),
      by_(by),
      trace_(trace) {
  layout_of(member_);  // throws if it is invalid
  remove_earlier_results(free_, layout_);
  require_numbers();
  require_valid_layout();
}

/// Throws InputError if a JSON pointer leads to a word.
void Optimisation::require_numbers() const {
  for (const FreeValue& value : free_) {
    for (const std::string& name : value.names) {
      if (!name.starts_with('/') || !layout_.contains(Json::json_pointer(name))) continue;
      if (!layout_.at(Json::json_pointer(name)).is_number())
        throw InputError(free_flag, fmt::format("\"{}\" leads to no number in {}", name, member_.source));
    }
  }
}

/// Throws InputError, with the reason for one of them, if no layout at the first positions is valid.
void Optimisation::require_valid_layout() const {
  std::string reason;
  for (const Position& position : first_positions(free_.size())) {
    try {
      with_values(layout_, study_point(free_, position), member_.source, free_flag);
      return;
    } catch (const InputError& error) {
      reason = error.what();
    }
  }
  throw InputError(reason);
}

void Optimisation::begin() {
  const auto is_evaluated = [&](const auto& make_layout, const std::string& stage, const Json& study) {
    Outcomes outcomes;
    try {
      treated_ = make_layout();
      outcomes = by_.evaluator->evaluate(treated_, member_.source);
      problem_.require_outcomes(outcomes, by_.name);
      typical_ = outcomes;
    } catch (const InputError& error) {
      reason_ = error.what();
    } catch (const SolverError& error) {
      reason_ = error.what();
    }
    record(stage, study, outcomes, typical_ ? "" : reason_);
    return typical_.has_value();
  };
  if (is_evaluated([&] { return layout_of(member_); }, "given", Json::object())) {
    given_ = typical_;
    return;
  }
  for (const Position& position : first_positions(free_.size())) {
    const StudyPoint point = study_point(free_, position);
    const auto make_layout = [&] { return with_values(layout_, point, member_.source, free_flag); };
    if (is_evaluated(make_layout, "first", study_of(point))) return;
  }
  throw InputError(reason_);
}

void Optimisation::find(const SearchSettings& settings) {
  StreamProgress progress(say, settings.evaluations, "evaluations");
  int done = 0;
  const auto evaluate_for_search = [&](const Position& position) {
    progress.update(done++);
    return evaluate(position, "search");
  };
  SearchResult found = search(static_cast<int>(free_.size()), evaluate_for_search, settings);
  require_found(found);
  find_ranges(found);
  best_ = with_values(layout_, study_point(free_, found.best), member_.source, free_flag);
  outcomes_ = by_.evaluator->evaluate(best_, member_.source);
  best_.study[to_text(problem_.objective)] = outcomes_.at(problem_.objective).value;
  for (std::size_t i = 0; i < free_.size(); ++i) {
    best_.study[free_[i].names.front() + "_from"] = free_[i].at(ranges_[i].first);
    best_.study[free_[i].names.front() + "_to"] = free_[i].at(ranges_[i].second);
  }
  report(found);
}

void Optimisation::require_treated_by(const NamedEvaluator& other) const {
  try {
    other.evaluator->require_treatable(treated_, member_.source);
  } catch (const InputError& error) {
    throw InputError("--verify-by", fmt::format("{} cannot run the layout: {}", other.name, error.what()));
  }
  if (given_ && !is_model(other.name))
    problem_.require_outcomes(other.evaluator->evaluate(treated_, member_.source), other.name);
}

bool Optimisation::verify(const NamedEvaluator& other) {
  const std::string objective = to_text(problem_.objective);
  std::string reason;
  try {
    const Outcomes outcomes = other.evaluator->evaluate(best_, member_.source);
    problem_.require_outcomes(outcomes, other.name);
    const double value = outcomes.at(problem_.objective).value, ours = outcomes_.at(problem_.objective).value;
    const std::string difference =
        ours == 0 ? "" : fmt::format(", {:+.2g} % from {}", 100 * (value - ours) / std::abs(ours), by_.name);
    say(fmt::format("{}: {} {:.6g}{}", other.name, objective, value, difference));
    report_constraints(outcomes, other.name + ": ");
    record("verification", best_.study, outcomes);
    best_.study[fmt::format("{}_by_{}", objective, other.name)] = value;
    return true;
  } catch (const InputError& error) {
    reason = error.what();
  } catch (const SolverError& error) {
    reason = error.what();
  }
  say(fmt::format("{} cannot verify the layout that was found: {}", other.name, reason));
  record("verification", best_.study, {}, reason);
  return false;
}

Trial Optimisation::evaluate(const Position& position, const std::string& stage) {
  const StudyPoint point = study_point(free_, position);
  Outcomes outcomes;
  try {
    const LayoutDocument layout = with_values(layout_, point, member_.source, free_flag);
    outcomes = by_.evaluator->evaluate(layout, member_.source);
    problem_.require_outcomes(outcomes, by_.name);
    record(stage, study_of(point), outcomes);
    return problem_.trial_of(outcomes, *typical_);
  } catch (const InputError& error) {
    reason_ = error.what();
  } catch (const SolverError& error) {
    reason_ = error.what();
  }
  record(stage, study_of(point), outcomes, reason_);
  return {};
}

void Optimisation::record(const std::string& stage, const Json& study, const Outcomes& outcomes,
                          const std::string& reason) {
  Json line{{"layout", member_.number}, {"stage", stage}, {"evaluation", ++recorded_}, {"study", study}};
  append_outcomes(outcomes, problem_.stated_outcomes(), line);
  line["feasible"] = reason.empty() ? Json(problem_.trial_of(outcomes, *typical_).is_feasible()) : Json();
  line["reason"] = reason.empty() ? Json() : Json(reason);
  append(trace_, dump_json_line(line));
}

void Optimisation::require_found(const SearchResult& found) const {
  if (found.trial.is_feasible()) return;
  if (!found.trial.value)
    throw SolverError(fmt::format("{}: {} could treat none of {} layouts; the last reason was: {}",
                                  member_.source, by_.name, found.evaluations, reason_));
  report_constraints(
      by_.evaluator->evaluate(with_values(layout_, study_point(free_, found.best), member_.source, free_flag),
                              member_.source),
      "the nearest layout: ");
  throw SolverError(
      fmt::format("{}: none of {} layouts is within the limits; widen the bounds of --free or the "
                  "limits of --subject-to, or give more --evaluations",
                  member_.source, found.evaluations));
}

/// Finds the ranges around the best position. If a position in them is better, it takes the place of the
/// best.
void Optimisation::find_ranges(SearchResult& found) {
  constexpr int max_rounds = 3;
  constexpr double min_improvement = 1e-7;  // relative change of the objective
  for (int round = 0; round < max_rounds; ++round) {
    SearchResult better = found;
    const auto evaluate_for_range = [&](const Position& position) {
      const Trial trial = evaluate(position, "range");
      if (trial.is_feasible() && *trial.value < *better.trial.value) {
        better.best = position;
        better.trial = trial;
      }
      return trial;
    };
    ranges_.clear();
    for (int i = 0; i < static_cast<int>(free_.size()); ++i)
      ranges_.push_back(flat_range(found, i, flat_share, evaluate_for_range));
    if (*found.trial.value - *better.trial.value <= min_improvement * std::abs(*found.trial.value)) return;
    found = better;
  }
}

void Optimisation::report(const SearchResult& found) const {
  const std::string objective = to_text(problem_.objective);
  const Outcome& value = outcomes_.at(problem_.objective);
  say(fmt::format("{}: {} {:.6g}{}{}, after {} evaluations by {}, then {}", member_.source, objective,
                  value.value, value.error > 0 ? fmt::format(" ± {:.2g}", value.error) : "",
                  given_ ? fmt::format(" ({:.6g} as given)", given_->at(problem_.objective).value) : "",
                  found.evaluations, found.global, found.local));
  if (!found.has_converged)
    say("warning: the search ended at its largest number of evaluations; more --evaluations can find more");
  if (const auto gap = outcomes_.find(ResultQuantity::gap); gap != outcomes_.end() && gap->second.value <= 0)
    say(fmt::format("warning: beads of an arm overlap in their stroke (gap {:.3g}); add --subject-to gap=0:",
                    gap->second.value));
  report_constraints(outcomes_, "");
  constexpr double near_bound = 1e-4;
  for (std::size_t i = 0; i < free_.size(); ++i) {
    const FreeValue& free = free_[i];
    const auto& [low, high] = ranges_[i];
    const double place = found.best[i];
    const char* bound = place < near_bound       ? ", at its lower bound"
                        : place > 1 - near_bound ? ", at its upper bound"
                                                 : "";
    say(fmt::format("{} = {:.6g}{}; {} at most 1 % worse from {:.4g} to {:.4g}", fmt::join(free.names, ", "),
                    free.at(place), bound, objective, free.at(low), free.at(high)));
  }
}

/// Reports constraints that are active or violated. `by`: start of the message.
void Optimisation::report_constraints(const Outcomes& outcomes, const std::string& by) const {
  constexpr double tolerance = 1e-4;  // relative distance from the bound of an active constraint
  for (const Constraint& constraint : problem_.constraints) {
    const double value = outcomes.at(constraint.outcome).value;
    const Problem one{.objective = problem_.objective, .constraints = {constraint}};
    const Trial trial = one.trial_of(outcomes, *typical_);
    const double violation = std::ranges::max(trial.violations);
    if (violation > tolerance) {
      say(fmt::format("{}{} = {:.6g} is outside its limits", by, to_text(constraint.outcome), value));
    } else if (violation > -tolerance) {
      say(fmt::format("{}{} = {:.6g} is at its limit", by, to_text(constraint.outcome), value));
    }
  }
}

}  // namespace beadswim
