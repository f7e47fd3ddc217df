#pragma once

#include <string>
#include <vector>

#include "beadswim/plan/run_plan.hpp"
#include "command_line/options.hpp"

// Conversion between command-line flags and a plan (expected errors and costs of possible runs).

namespace beadswim {

/// Returns the request for a plan in which every run has the settings that the command line fixes. The
/// request refers to `options` and `communicator`, which must exist as long as the request.
PlanRequest plan_request(const RunOptions& options, const Communicator& communicator);

/// Returns the flags with which beadswim-run performs a planned run, for example "--model lbm
/// --cells-per-radius 3 ...". `options`: command line that requested the plan.
std::string flags_of(const PlannedRun& run, const RunOptions& options);

/// Returns the reasons why runs are refused, each after the flags of such a run. Runs whose reasons differ
/// only in numbers share one entry.
std::vector<std::string> refusals(const RunPlan& plan, const RunOptions& options);

/// Returns the cheapest planned run whose expected error is within the tolerance. If there is none, returns
/// the run with the smallest expected error for a plan without --tolerance; otherwise throws InputError with
/// that run. Throws InputError with the reasons if all runs are refused.
const PlannedRun& choose_run(const RunPlan& plan, const RunOptions& options);

}  // namespace beadswim
