#pragma once

#include <string>

#include "beadswim/plan/run_plan.hpp"
#include "command_line/options.hpp"

// A plan in terms of the command line.

namespace beadswim {

/// Returns what the options leave open to a plan. The options must outlive it.
PlanRequest plan_request(const RunOptions& options, const Communicator& communicator);

/// Returns the flags that make a planned run: "--model lbm --cells-per-radius 3 ...". `options`: those that
/// asked for the plan.
std::string flags_of(const PlannedRun& run, const RunOptions& options);

/// Throws InputError, with the best that can be had, if no run is within the tolerance.
const PlannedRun& chosen(const RunPlan& plan, const RunOptions& options);

}  // namespace beadswim
