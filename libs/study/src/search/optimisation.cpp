#include "beadswim/study/optimisation.hpp"

#include <fmt/core.h>

#include <cmath>
#include <random>

#include "beadswim/core/error.hpp"
#include "beadswim/core/joined.hpp"
#include "beadswim/core/reason_against.hpp"
#include "beadswim/study/stream.hpp"

namespace beadswim {
namespace {

constexpr double flat_share = 0.01;  // loss of the objective in the ranges that are reported

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

/// The search for one layout.
class LayoutSearch {
 public:
  LayoutSearch(const StreamMember& member, const Optimisation& optimisation)
      : member_(member),
        json_(parse_json(member.text, member.source)),  // unchanged: absent rest lengths stay absent
        all_(optimisation),
        free_(optimisation.free),
        problem_(optimisation.problem) {
    layout_of(member_);  // throws if it is invalid
    remove_earlier_results(free_, json_);
    require_numbers();
    require_valid_layout();
  }

  Optimum run() {
    begin();
    if (all_.verifier) require_treated_by(*all_.verifier);
    find();
    Optimum optimum{.layout = best_};
    if (all_.verifier) optimum.is_unverified = !is_verified_by(*all_.verifier, optimum.layout.study);
    return optimum;
  }

 private:
  /// Throws InputError if a JSON pointer leads to a word.
  void require_numbers() const {
    for (const FreeValue& value : free_) {
      for (const std::string& name : value.names) {
        if (!name.starts_with('/') || !json_.contains(Json::json_pointer(name))) continue;
        if (!json_.at(Json::json_pointer(name)).is_number())
          throw InputError(Setting::free_quantity, "\"{}\" leads to no number in {}", name, member_.source);
      }
    }
  }

  /// Throws InputError, with the reason for one of them, if no layout at the first positions is valid.
  void require_valid_layout() const {
    std::string reason;
    for (const Position& position : first_positions(free_.size())) {
      reason = reason_against([&] { layout_with(study_point(free_, position)); });
      if (reason.empty()) return;
    }
    throw InputError(reason);
  }

  LayoutDocument layout_with(const StudyPoint& point) const {
    return with_values(json_, point, member_.source, name_of(Setting::free_quantity));
  }

  Outcomes outcomes_by(const Evaluator& evaluator, const LayoutDocument& layout) const {
    return evaluator.evaluate(layout, member_.source);
  }

  /// Evaluates the layout as it is, or if that fails others in the bounds.
  void begin() {
    if (is_evaluated({}, "given")) {
      given_ = outcomes_;
      return;
    }
    for (const Position& position : first_positions(free_.size()))
      if (is_evaluated(study_point(free_, position), "first")) return;
    throw InputError(reason_);
  }

  /// Evaluates and records the layout with these values; without values, the layout as it is. Returns false,
  /// with the reason in `reason_`, if it cannot be evaluated or gives not all outcomes of the problem.
  bool is_evaluated(const StudyPoint& point, const std::string& stage) {
    outcomes_.clear();
    reason_ = reason_against([&] {
      layout_ = point.empty() ? layout_of(member_) : layout_with(point);
      outcomes_ = outcomes_by(all_.by, layout_);
      problem_.require_outcomes(outcomes_, all_.by.name);
    });
    if (reason_.empty() && !typical_) typical_ = outcomes_;
    record(stage, study_of(point), outcomes_, reason_);
    return reason_.empty();
  }

  Trial trial_at(const Position& position, const std::string& stage) {
    return is_evaluated(study_point(free_, position), stage) ? problem_.trial_of(outcomes_, *typical_)
                                                             : Trial();
  }

  /// Throws InputError if another method cannot treat the first layout that was evaluated or does not give
  /// the outcomes, or if a model cannot run it.
  void require_treated_by(const Evaluator& other) const {
    if (!other.require_treatable) {
      if (given_) problem_.require_outcomes(outcomes_by(other, layout_), other.name);
      return;
    }
    try {
      other.require_treatable(layout_, member_.source);
    } catch (const InputError& error) {
      throw InputError(Setting::verification, "{} cannot run the layout: {}", other.name, error.what());
    }
  }

  void find() {
    StreamProgress progress(all_.message, all_.search.evaluations, "evaluations");
    int done = 0;
    const auto evaluate = [&](const Position& position) {
      progress.update(done++);
      return trial_at(position, "search");
    };
    SearchResult found = search(static_cast<int>(free_.size()), evaluate, all_.search);
    require_found(found);
    find_ranges(found);
    best_ = layout_with(study_point(free_, found.best));
    outcomes_ = outcomes_by(all_.by, best_);
    best_.study[to_text(problem_.objective)] = outcomes_.at(problem_.objective).value;
    for (std::size_t i = 0; i < free_.size(); ++i) {
      best_.study[free_[i].names.front() + "_from"] = free_[i].at(ranges_[i].first);
      best_.study[free_[i].names.front() + "_to"] = free_[i].at(ranges_[i].second);
    }
    report(found);
  }

  void require_found(const SearchResult& found) const {
    if (found.trial.is_feasible()) return;
    if (!found.trial.value)
      throw SolverError(fmt::format("{}: {} could treat none of {} layouts; the last reason was: {}",
                                    member_.source, all_.by.name, found.evaluations, reason_));
    report_constraints(outcomes_by(all_.by, layout_with(study_point(free_, found.best))),
                       "the nearest layout: ");
    throw SolverError(fmt::format(
        "{}: none of {} layouts is within the limits; widen the bounds of {} or the limits of {}, or give "
        "more {}",
        member_.source, found.evaluations, Setting::free_quantity, Setting::limit, Setting::evaluations));
  }

  /// Finds the ranges around the best position. If a position in them is better, it takes the place of the
  /// best.
  void find_ranges(SearchResult& found) {
    constexpr int max_rounds = 3;
    constexpr double min_improvement = 1e-7;  // relative change of the objective
    for (int round = 0; round < max_rounds; ++round) {
      SearchResult better = found;
      const auto evaluate = [&](const Position& position) {
        const Trial trial = trial_at(position, "range");
        if (trial.is_feasible() && *trial.value < *better.trial.value) {
          better.best = position;
          better.trial = trial;
        }
        return trial;
      };
      ranges_.clear();
      for (int i = 0; i < static_cast<int>(free_.size()); ++i)
        ranges_.push_back(flat_range(found, i, flat_share, evaluate));
      if (*found.trial.value - *better.trial.value <= min_improvement * std::abs(*found.trial.value)) return;
      found = better;
    }
  }

  /// Evaluates the layout that was found by another method or model, and adds the objective to `study`.
  /// Returns false if this fails.
  bool is_verified_by(const Evaluator& other, Json& study) {
    Outcomes outcomes;
    const std::string reason = reason_against([&] {
      outcomes = outcomes_by(other, best_);
      problem_.require_outcomes(outcomes, other.name);
    });
    if (!reason.empty()) {
      all_.message(fmt::format("{} cannot verify the layout that was found: {}", other.name, reason));
      record("verification", study, {}, reason);
      return false;
    }
    const std::string objective = to_text(problem_.objective);
    const double value = outcomes.at(problem_.objective).value, ours = outcomes_.at(problem_.objective).value;
    const std::string difference =
        ours == 0 ? ""
                  : fmt::format(", {:+.2g} % from {}", 100 * (value - ours) / std::abs(ours), all_.by.name);
    all_.message(fmt::format("{}: {} {:.6g}{}", other.name, objective, value, difference));
    report_constraints(outcomes, other.name + ": ");
    record("verification", study, outcomes, "");
    study[fmt::format("{}_by_{}", objective, other.name)] = value;
    return true;
  }

  void record(const std::string& stage, const Json& study, const Outcomes& outcomes,
              const std::string& reason) {
    Json line{{"layout", member_.number}, {"stage", stage}, {"evaluation", ++recorded_}, {"study", study}};
    append_outcomes(outcomes, problem_.stated_outcomes(), line);
    line["feasible"] = reason.empty() ? Json(problem_.trial_of(outcomes, *typical_).is_feasible()) : Json();
    line["reason"] = reason.empty() ? Json() : Json(reason);
    all_.trace(line);
  }

  void report(const SearchResult& found) const {
    const std::string objective = to_text(problem_.objective);
    const Outcome& value = outcomes_.at(problem_.objective);
    all_.message(
        fmt::format("{}: {} {:.6g}{}{}, after {} evaluations by {}, then {}", member_.source, objective,
                    value.value, value.error > 0 ? fmt::format(" ± {:.2g}", value.error) : "",
                    given_ ? fmt::format(" ({:.6g} as given)", given_->at(problem_.objective).value) : "",
                    found.evaluations, found.global, found.local));
    if (!found.has_converged)
      all_.message(
          fmt::format("warning: the search ended at its largest number of evaluations; more {} can find more",
                      Setting::evaluations));
    if (const auto gap = outcomes_.find(ResultQuantity::gap);
        gap != outcomes_.end() && gap->second.value <= 0)
      all_.message(fmt::format("warning: beads of an arm overlap in their stroke (gap {:.3g}); add {} gap=0:",
                               gap->second.value, Setting::limit));
    report_constraints(outcomes_, "");
    constexpr double near_bound = 1e-4;
    for (std::size_t i = 0; i < free_.size(); ++i) {
      const FreeValue& free = free_[i];
      const auto& [low, high] = ranges_[i];
      const double place = found.best[i];
      const char* bound = place < near_bound       ? ", at its lower bound"
                          : place > 1 - near_bound ? ", at its upper bound"
                                                   : "";
      all_.message(fmt::format("{} = {:.6g}{}; {} at most 1 % worse from {:.4g} to {:.4g}",
                               joined(free.names, ", "), free.at(place), bound, objective, free.at(low),
                               free.at(high)));
    }
  }

  /// Reports constraints that are active or violated. `by`: start of the message.
  void report_constraints(const Outcomes& outcomes, const std::string& by) const {
    constexpr double tolerance = 1e-4;  // relative distance from the bound of an active constraint
    for (const Constraint& constraint : problem_.constraints) {
      const double value = outcomes.at(constraint.outcome).value;
      const Problem one{.objective = problem_.objective, .constraints = {constraint}};
      const Trial trial = one.trial_of(outcomes, *typical_);
      const double violation = std::ranges::max(trial.violations);
      if (violation > tolerance) {
        all_.message(
            fmt::format("{}{} = {:.6g} is outside its limits", by, to_text(constraint.outcome), value));
      } else if (violation > -tolerance) {
        all_.message(fmt::format("{}{} = {:.6g} is at its limit", by, to_text(constraint.outcome), value));
      }
    }
  }

  const StreamMember& member_;
  Json json_;
  const Optimisation& all_;
  const std::vector<FreeValue>& free_;
  const Problem& problem_;
  std::optional<Outcomes> given_;    ///< outcomes of the layout as it is; nullopt: it cannot be evaluated
  std::optional<Outcomes> typical_;  ///< outcomes of the first layout that was evaluated
  LayoutDocument layout_, best_;     ///< evaluated most recently; found
  Outcomes outcomes_;                ///< of the layout that was evaluated most recently
  std::string reason_;               ///< why it could not be evaluated; empty if it could
  std::vector<std::pair<double, double>> ranges_;  ///< ends of the range of each free value
  int recorded_ = 0;                               ///< number of records in the trace
};

}  // namespace

void require_searchable(const StreamMember& member, const Optimisation& optimisation) {
  LayoutSearch(member, optimisation);
}

Optimum optimise(const StreamMember& member, const Optimisation& optimisation) {
  return LayoutSearch(member, optimisation).run();
}

}  // namespace beadswim
