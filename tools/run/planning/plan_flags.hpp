#pragma once

#include <string>

#include "beadswim/plan/run_plan.hpp"
#include "command_line/options.hpp"

// Conversion between the flags of the command line and a plan.

namespace beadswim {

/// Returns the request for a plan whose runs all have the settings of the command line. The request refers to
/// `options` and `communicator`, which must exist as long as the request.
PlanRequest plan_request(const RunOptions& options, const Communicator& communicator);

/// Returns the flags for a planned run, for example "--model lbm --cells-per-radius 3 ...". `options`:
/// command line that requested the plan.
std::string flags_of(const PlannedRun& run, const RunOptions& options);

/// Returns the cheapest run within the tolerance. Throws InputError if there is none; the message states the
/// run with the smallest expected error.
const PlannedRun& choose_run(const RunPlan& plan, const RunOptions& options);

}  // namespace beadswim
