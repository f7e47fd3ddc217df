#pragma once

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
  /// Settings that all candidates share. The plan replaces the model and the tolerance of the mobility. It
  /// varies cells per radius and relaxation time of the lattice if they are not set.
  RunSettings settings;
  std::optional<RunModel> model;       ///< nullopt: all models
  std::optional<Precision> precision;  ///< nullopt: both precisions
  std::optional<double> tolerance;     ///< for velocity and arm amplitudes; nullopt: 0.03
  bool has_advice = false;             ///< true: RunPlan::hard and proposals are filled

  /// Throws InputError if the user has set an option that has no effect in a run with these settings.
  std::function<void(const RunSettings&)> require_choices_apply;
  /// Returns the cost of lattice steps. It is called once, for the first lattice that can run, or never.
  /// Collective.
  std::function<LatticeSpeed()> lattice_speed;
};

/// A candidate: a possible run, its expected error and its cost.
struct PlannedRun {
  RunSettings settings;
  std::string refused;  ///< reason why the run is impossible or its result wrong; empty if none
  ErrorEstimate error;
  double core_seconds = 0;  ///< cost with the number of ranks of this program
  double memory_bytes = 0;
  double output_bytes = 0;  ///< disk space of trajectory, flow fields and checkpoints
};

/// A smaller scene with the same result within the tolerance. It is either the swimmer in a smaller periodic
/// box, or the smallest cell whose repetition gives the scene.
struct Proposal {
  std::string what;
  std::optional<Vec3> box = std::nullopt;  ///< edges of the box [length]; nullopt: the repeated cell
};

/// All candidates, the chosen one, and advice.
struct RunPlan {
  double tolerance = 0;  ///< largest accepted relative error of velocity and arm amplitudes
  std::vector<PlannedRun> runs;
  std::optional<std::size_t> choice;  ///< cheapest run within the tolerance; nullopt if there is none
  std::optional<std::size_t> best;    ///< run with the smallest error; nullopt if all are refused
  std::vector<std::string> hard;      ///< difficulties of the scene, one line each; filled if has_advice
  std::vector<Proposal> proposals;    ///< filled if has_advice
};

/// Plans a run of the layout: evaluates all models and resolutions that the request leaves open. `source`:
/// name of the layout in messages. Throws InputError if the layout is invalid for all models, for example if
/// a swimmer has no springs. Collective; returns the same plan on all ranks.
RunPlan plan_run(const Layout& layout, const PlanRequest& request, const std::string& source,
                 const Communicator& communicator);

}  // namespace beadswim
