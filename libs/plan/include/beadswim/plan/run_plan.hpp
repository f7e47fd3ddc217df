#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "beadswim/core/communicator.hpp"
#include "beadswim/plan/lattice_speed.hpp"
#include "beadswim/plan/model_errors.hpp"
#include "beadswim/plan/run_settings.hpp"
#include "beadswim/scene/layout.hpp"

// Comparison of possible runs of a layout (candidates): expected error, and cost on this machine, for each
// model and resolution. The errors come from theory and from measured errors of lattice runs. Page:
// docs/choosing-a-model.md.

namespace beadswim {

/// Restrictions on the candidates of a plan.
struct PlanRequest {
  /// Settings that all candidates (possible runs) share, except the model, which the plan chooses. It also
  /// varies cells per radius and relaxation time if they are not set. If the number of levels of cells is not
  /// set, each candidate has the cheapest number.
  RunSettings settings;
  std::optional<RunModel> model;       ///< nullopt: all models
  std::optional<Precision> precision;  ///< nullopt: both precisions
  /// Highest moment of the forces in the models multipole and unsteady; nullopt: the default for multipole,
  /// every order for unsteady.
  std::optional<int> multipole_order;
  std::optional<double> tolerance;  ///< largest accepted relative error; nullopt: 0.03
  bool has_advice = false;          ///< true: RunPlan::hard and RunPlan::proposals are filled
  bool may_change_scene = true;     ///< false: RunPlan::proposals stays empty
  long steps_done = 0;              ///< time steps that a restart does not repeat

  /// Throws InputError if the user has set an option that has no effect in a run with these settings.
  std::function<void(const RunSettings&)> require_choices_apply;
  /// Returns the cost of lattice steps on this machine. The plan calls this function at most once, for the
  /// first candidate with a lattice that can run. Collective.
  std::function<LatticeSpeed()> lattice_speed;
};

/// A candidate: a possible run, its expected error and its cost.
struct PlannedRun {
  RunSettings settings;
  std::string refused;  ///< reason why the run is impossible or its result wrong; empty if none
  ErrorRange error;
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
  double tolerance = 0;  ///< largest accepted relative error of velocity and arm amplitudes
  std::vector<PlannedRun> runs;
  std::optional<std::size_t> choice;  ///< index in `runs`: cheapest run within the tolerance; nullopt if none
  std::optional<std::size_t> best;    ///< index in `runs`: run of smallest error; nullopt if all are refused
  std::vector<std::string> hard;      ///< difficulties of the scene, one line each; empty without advice
  std::vector<Proposal> proposals;    ///< smaller scenes; empty without advice
};

/// Plans a run of the layout: estimates error and cost of all models and resolutions that the request
/// permits, and chooses one. `source`: name of the layout in messages. Throws InputError if the layout is
/// invalid for all models, for example if a swimmer has no springs. Collective; returns the same plan on all
/// ranks.
RunPlan plan_run(const Layout& layout, const PlanRequest& request, const std::string& source,
                 const Communicator& communicator);

}  // namespace beadswim
