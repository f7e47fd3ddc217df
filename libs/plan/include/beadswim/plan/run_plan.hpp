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

// What a run would be by each model and resolution: its error, from theory and from what lattices were
// measured to be wrong by, and its cost on this machine. Page: docs/choosing-a-model.md.

namespace beadswim {

/// Which runs a plan weighs.
struct PlanRequest {
  /// Settings that all runs share. The plan chooses model and tolerance of the mobility anew, and the
  /// lattice's cells per radius and relaxation time where they are none.
  RunSettings settings;
  std::optional<RunModel> model;       ///< the only model to weigh; none: all
  std::optional<Precision> precision;  ///< the only precision to weigh; none: both
  std::optional<double> tolerance;     ///< largest relative error of velocity and arms' amplitudes; none: 3 %
  bool has_advice = false;             ///< names hard cases and proposes smaller scenes

  /// Throws InputError if the user has chosen what a run with these settings does not have.
  std::function<void(const RunSettings&)> require_choices_apply;
  /// Returns the cost of lattice steps. Called at most once, for the first lattice that can run. Collective.
  std::function<LatticeSpeed()> lattice_speed;
};

/// A candidate: a run that could be.
struct PlannedRun {
  RunSettings settings;
  std::string refused;  ///< why it cannot be, or is wrong in kind; empty if it can
  ErrorEstimate error;
  double core_seconds = 0;  ///< on as many ranks as this
  double memory_bytes = 0;
  double output_bytes = 0;  ///< trajectory, flow and checkpoints
};

/// A smaller scene that would do: the one swimmer alone in this periodic box, or the cell that the scene
/// repeats.
struct Proposal {
  std::string what;
  std::optional<Vec3> box = std::nullopt;  ///< edges [length]; none: the cell
};

struct RunPlan {
  double tolerance = 0;  ///< asked for: largest relative error of velocity and arms' amplitudes
  std::vector<PlannedRun> runs;
  std::optional<std::size_t> choice;  ///< the cheapest within the tolerance; none if none is
  std::optional<std::size_t> best;    ///< the smallest error; none if all are refused
  std::vector<std::string> hard;      ///< what is hard about the scene, each a line; with advice
  std::vector<Proposal> proposals;    ///< with advice
};

/// Plans a run of the layout, which `source` names, by all models and resolutions that the request leaves
/// open. Throws InputError as runs of unsound layouts do. Collective; the same on all ranks.
RunPlan plan_run(const Layout& layout, const PlanRequest& request, const std::string& source,
                 const Communicator& communicator);

}  // namespace beadswim
