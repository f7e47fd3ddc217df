#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "beadswim/core/communicator.hpp"
#include "beadswim/io/json.hpp"
#include "beadswim/plan/lattice_speed.hpp"
#include "beadswim/plan/model_errors.hpp"
#include "beadswim/run/model.hpp"
#include "beadswim/run/run_settings.hpp"
#include "beadswim/scene/layout.hpp"

// Comparison of possible runs of a layout (candidates): expected error, and cost on this machine, for each
// model and resolution. The errors come from theory and from measured errors of lattice runs. Page:
// docs/choosing-a-model.md.

namespace beadswim {

/// Restrictions on the candidates of a plan.
struct PlanRequest {
  /// Settings that all candidates (possible runs) share. The plan chooses the model if it is automatic,
  /// varies cells per radius and relaxation time if they are not set, and all settings that it can vary
  /// unless is_fixed().
  RunSettings settings;
  std::set<Setting> chosen;         ///< settings with the value that the user has chosen
  bool is_restart = false;          ///< true: a run with the scene and the settings of a checkpoint goes on
  std::optional<double> tolerance;  ///< largest accepted relative error; nullopt: 0.03
  bool has_advice = false;          ///< true: RunPlan::hard and RunPlan::proposals are filled
  long steps_done = 0;              ///< time steps that a restart does not repeat
  /// Returns the cost of lattice steps on this machine. The plan calls this function at most once, for the
  /// first candidate with a lattice that can run. Collective.
  std::function<LatticeSpeed()> lattice_speed;

  /// Returns true if all candidates have the value of this setting that `settings` has.
  bool is_fixed(Setting setting) const { return is_restart || chosen.contains(setting); }
  /// Returns true if the model may be used.
  bool allows(RunModel model) const {
    return settings.model == RunModel::automatic || settings.model == model;
  }
};

/// A candidate: a possible run, its expected error and its cost.
struct PlannedRun {
  RunSettings settings;
  std::string refused;  ///< reason why the run is impossible or its result wrong; empty if none
  RunErrors errors;
  double core_seconds = 0;  ///< expected cost with the present number of ranks [core-seconds]
  double memory_bytes = 0;
  double output_bytes = 0;            ///< disk space of trajectory, flow fields and checkpoints
  std::vector<std::int64_t> cells{};  ///< cells of each level, coarsest first; empty without a lattice
};

/// Proposal to run a smaller scene, whose velocity and arm amplitudes differ from those of the layout by less
/// than the tolerance of the plan. The smaller scene is either a single swimmer in a smaller periodic box, or
/// the smallest cell whose periodic repetition gives the layout.
struct Proposal {
  std::string what;
  std::optional<Vec3> box = std::nullopt;  ///< edges of the smaller box [length]; nullopt: repeated cell
};

/// Result of plan_run(): all candidates (possible runs), the chosen candidate, and advice.
struct RunPlan {
  PlanRequest request;
  double tolerance = 0;  ///< largest accepted relative error of velocity and arm amplitudes
  int ranks = 1;
  std::vector<PlannedRun> runs;
  std::optional<std::size_t> choice;  ///< index in `runs`: cheapest run within the tolerance; nullopt if none
  std::optional<std::size_t> best;    ///< index in `runs`: run of smallest error; nullopt if all are refused
  std::vector<std::string> hard;      ///< difficulties of the scene, one line each; empty without advice
  std::vector<Proposal> proposals;    ///< smaller scenes; empty without advice
  std::string unvalidated;  ///< name of a type for which errors have not been validated; empty if none
};

/// Plans a run of the layout: estimates error and cost of all models and resolutions that the request
/// permits, and chooses one. `source`: name of the layout in messages. Throws InputError if the layout is
/// invalid for all models, for example if a swimmer has no springs. Collective; returns the same plan on all
/// ranks.
RunPlan plan_run(const Layout& layout, const PlanRequest& request, const std::string& source,
                 const Communicator& communicator);

/// Returns the cheapest planned run whose expected error is within the tolerance. If there is none, returns
/// the run with the smallest expected error for a plan with advice and without tolerance; otherwise throws
/// InputError with that run. Throws InputError with the reasons if all runs are refused.
const PlannedRun& choose_run(const RunPlan& plan);

// Return the expected errors of a run: of the layout, by its description, or of a run of the plan. Throw
// InputError with the reason if the errors are not known.
ExpectedErrors expected_errors(const Layout& layout, const ModelPlan& plan);
ExpectedErrors expected_errors(const RunPlan& plan, const PlannedRun& run);

/// Sets the expected errors of a run, which `expected` returns. Adds a warning if they are larger than
/// `accepted`, or if `expected` throws because they are not known.
void add_expected_errors(ModelPlan& plan, double accepted, const std::function<ExpectedErrors()>& expected);

/// Formats the plan as text. A table lists all possible runs with mobilities, and those lattice runs for
/// which no cheaper run has a similar or smaller expected error. Below the table, the text states the meaning
/// of the errors, and lists the impossible runs with their reasons ("refused"), properties of the scene that
/// make runs inaccurate or impossible ("hard"), and proposed layouts ("propose"). `layout`: file of the
/// layout, for the commands that make proposed layouts.
std::string plan_table(const RunPlan& plan, const std::string& layout);

/// Returns the head of the table, two lines. `indent`: begin of both.
std::string plan_head(const std::string& indent = "");

/// Returns the row of a run in the table. `remark`: end of the row.
std::string plan_row(const RunPlan& plan, const PlannedRun& run, const std::string& remark);

/// Returns the reasons why runs are refused, each after the settings of such a run. Runs whose reasons differ
/// only in numbers share one entry.
std::vector<std::string> refusals(const RunPlan& plan);

/// Returns a size as text, such as "1.2 GB".
std::string size_text(double bytes);

/// Returns all runs of the plan as a document that follows schemas/plan.schema.json, without provenance.
Json plan_to_json(const RunPlan& plan, const std::string& layout);

}  // namespace beadswim
