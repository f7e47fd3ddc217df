#include "optimisation.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "beadswim/core/error.hpp"
#include "beadswim/tools/stream_jobs.hpp"

namespace beadswim {
namespace {

constexpr double flat_share = 0.01;  // loss of the objective in the ranges that are reported

/// Adds all outcomes to a line of the trace; those that are missing or not finite are null.
void append_outcomes(const Outcomes& outcomes, Json& line) {
  for (const auto& [outcome, name] : name_table<Outcome>) {
    const auto found = outcomes.find(outcome);
    const bool is_known = found != outcomes.end() && std::isfinite(found->second.value);
    line[name] = is_known ? Json(found->second.value) : Json();
  }
}

Json study_of(const StudyPoint& point) {
  Json study = Json::object();
  for (const auto& [name, value] : point) study[name] = value;
  return study;
}

}  // namespace

void say(const std::string& text) {
  print_to_stderr(fmt::format("{}: {}\n", optimise_name, text));
}

Optimisation::Optimisation(const StreamMember& member, const Aims& aims, const std::vector<FreeValue>& free,
                           const NamedEvaluator& by, const OpenFile& trace)
    : member_(member),
      layout_(parse_json(member.text, member.source)),
      aims_(aims),
      free_(free),
      by_(by),
      trace_(trace) {}

void Optimisation::begin() {
  require_valid_layouts();
  try {
    given_ = by_.evaluator->evaluate(layout_of(member_), member_.source);
  } catch (const SolverError& error) {
    record("given", Json::object(), {}, error.what());
    return;
  }
  aims_.require_outcomes(*given_, by_.name);
  record("given", Json::object(), *given_);
}

/// Throws InputError, with the reason for one of them, if the layouts in the middle and at the ends of all
/// bounds are invalid.
void Optimisation::require_valid_layouts() const {
  for (const double coordinate : {0.5, 0.0, 1.0}) {
    try {
      with_values(layout_, study_point(free_, Position(free_.size(), coordinate)), member_.source, free_flag);
      return;
    } catch (const InputError&) {
      if (coordinate == 1.0) throw;
    }
  }
}

void Optimisation::find(const SearchSettings& settings) {
  StreamProgress progress(optimise_name, settings.evaluations, "evaluations");
  int done = 0;
  const auto evaluate_for_search = [&](const Position& position) {
    progress.update(done++);
    return evaluate(position, "search");
  };
  const SearchResult found = search(static_cast<int>(free_.size()), evaluate_for_search, settings);
  require_found(found);
  best_ = with_values(layout_, study_point(free_, found.best), member_.source, free_flag);
  outcomes_ = by_.evaluator->evaluate(best_, member_.source);
  best_.study[to_text(aims_.objective)] = outcomes_.at(aims_.objective).value;
  report_best(found);
  for (int i = 0; i < static_cast<int>(free_.size()); ++i) find_range(found, i);
}

void Optimisation::verify(const NamedEvaluator& other) {
  const std::string objective = to_text(aims_.objective);
  const Outcomes outcomes = other.evaluator->evaluate(best_, member_.source);
  aims_.require_outcomes(outcomes, other.name);
  const double value = outcomes.at(aims_.objective).value, ours = outcomes_.at(aims_.objective).value;
  say(fmt::format("{}: {} {:.6g}, {:+.2g} % from {}", other.name, objective, value,
                  100 * (value - ours) / std::abs(ours), by_.name));
  record("verification", best_.study, outcomes);
  best_.study[fmt::format("{}_by_{}", objective, other.name)] = value;
}

Trial Optimisation::evaluate(const Position& position, const std::string& stage) {
  const StudyPoint point = study_point(free_, position);
  try {
    const LayoutDocument layout = with_values(layout_, point, member_.source, free_flag);
    const Outcomes outcomes = by_.evaluator->evaluate(layout, member_.source);
    aims_.require_outcomes(outcomes, by_.name);
    const Trial trial = aims_.trial_of(outcomes);
    record(stage, study_of(point), outcomes, "", trial.is_feasible());
    return trial;
  } catch (const InputError& error) {
    reason_ = error.what();
  } catch (const SolverError& error) {
    reason_ = error.what();
  }
  record(stage, study_of(point), {}, reason_);
  return {};
}

void Optimisation::record(const std::string& stage, const Json& study, const Outcomes& outcomes,
                          const std::string& reason, std::optional<bool> is_feasible) {
  Json line{{"layout", member_.number}, {"stage", stage}, {"evaluation", ++recorded_}, {"study", study}};
  append_outcomes(outcomes, line);
  line["feasible"] = is_feasible ? Json(*is_feasible) : Json();
  line["reason"] = reason.empty() ? Json() : Json(reason);
  append(trace_, dump_json_line(line));
}

void Optimisation::require_found(const SearchResult& found) const {
  if (found.trial.is_feasible()) return;
  if (!found.trial.value)
    throw SolverError(fmt::format("{}: {} could treat none of {} layouts; the last reason was: {}",
                                  member_.source, by_.name, found.evaluations, reason_));
  throw SolverError(
      fmt::format("{}: none of {} layouts is within the limits; the best exceeds one by {:.2g} of it; widen "
                  "the bounds of --free or the limits of --subject-to, or give more --evaluations",
                  member_.source, found.evaluations, found.trial.largest_excess()));
}

void Optimisation::report_best(const SearchResult& found) const {
  const ResultValue& value = outcomes_.at(aims_.objective);
  say(fmt::format("{}: {} {:.6g}{}{}, after {} evaluations by {}, then {}", member_.source,
                  to_text(aims_.objective), value.value,
                  value.error > 0 ? fmt::format(" ± {:.2g}", value.error) : "",
                  given_ ? fmt::format(" ({:.6g} as given)", given_->at(aims_.objective).value) : "",
                  found.evaluations, found.global, found.local));
  if (const auto gap = outcomes_.find(Outcome::gap); gap != outcomes_.end() && gap->second.value <= 0)
    say(fmt::format("warning: beads of an arm overlap in their stroke (gap {:.3g}); add --subject-to gap=0:",
                    gap->second.value));
  for (const Limit& limit : aims_.limits) {
    const double reached = outcomes_.at(limit.outcome).value;
    for (const double bound : {limit.low, limit.high})
      if (std::isfinite(bound) && std::abs(reached - bound) <= 1e-4 * std::abs(bound))
        say(fmt::format("{} = {:.6g} is at its limit", to_text(limit.outcome), reached));
  }
}

void Optimisation::find_range(const SearchResult& found, int index) {
  constexpr double near_bound = 1e-4;
  const auto [low, high] = flat_range(
      found, index, flat_share, [this](const Position& position) { return evaluate(position, "range"); });
  const FreeValue& free = free_[static_cast<std::size_t>(index)];
  const double place = found.best[static_cast<std::size_t>(index)];
  best_.study[free.names.front() + "_from"] = free.at(low);
  best_.study[free.names.front() + "_to"] = free.at(high);
  const char* bound = place < near_bound       ? ", at its lower bound"
                      : place > 1 - near_bound ? ", at its upper bound"
                                               : "";
  say(fmt::format("{} = {:.6g}{}; {} at most 1 % worse from {:.4g} to {:.4g}", fmt::join(free.names, ", "),
                  free.at(place), bound, to_text(aims_.objective), free.at(low), free.at(high)));
}

}  // namespace beadswim
