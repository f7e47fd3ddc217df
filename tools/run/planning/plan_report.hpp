#pragma once

#include <string>

#include "beadswim/io/json.hpp"
#include "beadswim/plan/run_plan.hpp"
#include "command_line/options.hpp"

namespace beadswim {

/// Formats the plan as text for standard error. A table lists all possible mobility runs, and the lattice
/// runs for which no cheaper run has a similar or smaller error. Below it stand the impossible runs, grouped
/// by reason, the difficulties of the scene and the proposals. `options`: command line that requested the
/// plan.
std::string plan_table(const RunPlan& plan, const RunOptions& options, const Communicator& communicator);

/// Returns all runs of the plan in the format of schemas/plan.schema.json.
Json plan_to_json(const RunPlan& plan, const RunOptions& options, const Communicator& communicator);

}  // namespace beadswim
