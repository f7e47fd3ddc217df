#pragma once

#include <optional>
#include <string>
#include <vector>

#include "beadswim/core/communicator.hpp"
#include "beadswim/documents/layout_document.hpp"
#include "beadswim/plan/model_errors.hpp"
#include "options.hpp"

// What a run would be by each model and resolution: its error, from theory and from what lattices were
// measured to be wrong by, and its cost on this machine. Page: docs/choosing-a-model.md.

namespace beadswim {

/// A run that could be.
struct PlannedRun {
  RunOptions options;   ///< that make it
  std::string refused;  ///< why it cannot be, or is wrong in kind; empty if it can
  ErrorEstimate error;
  double core_seconds = 0;  ///< on as many ranks as this
  double memory_bytes = 0;
  double output_bytes = 0;  ///< trajectory, flow and checkpoints
};

/// A smaller scene that would do.
struct Proposal {
  std::string what, command;
};

struct RunPlan {
  double tolerance = 0;  ///< asked for: largest relative error of velocity and arms' amplitudes
  std::vector<PlannedRun> runs;
  std::optional<std::size_t> choice;  ///< the cheapest within the tolerance; none if none is
  std::optional<std::size_t> best;    ///< the smallest error; none if all are refused
  std::vector<std::string> hard;      ///< what is hard about the scene, each a line; with --plan
  std::vector<Proposal> proposals;    ///< with --plan
};

/// The flags that make a planned run: "--model lbm --cells-per-radius 3 ...".
std::string flags_of(const PlannedRun& run);

/// Plans a run of the layout by all models and resolutions that the options leave open, for the error that
/// they ask for or 3 %. Throws InputError as runs of unsound layouts do. Collective; the same on all ranks.
RunPlan plan_run(const Layout& layout, const RunOptions& options, const std::string& source,
                 const Communicator& communicator);

/// Throws InputError, with the best that can be had, if no run is within the tolerance.
const PlannedRun& chosen(const RunPlan& plan);

}  // namespace beadswim
