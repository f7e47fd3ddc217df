#pragma once

#include <string>

#include "beadswim/io/json.hpp"
#include "beadswim/plan/run_plan.hpp"
#include "command_line/options.hpp"

namespace beadswim {

/// Formats the plan as text for standard error. A table lists all possible runs with mobilities, and those
/// lattice runs for which no cheaper run has a similar or smaller expected error. Below the table, the text
/// states the meaning of the errors, and lists the impossible runs with their reasons ("refused"), properties
/// of the scene that make runs inaccurate or impossible ("hard"), and proposed layouts ("propose").
/// `options`: command line that requested the plan.
std::string plan_table(const RunPlan& plan, const RunOptions& options, const Communicator& communicator);

/// Returns all runs of the plan as a document that follows schemas/plan.schema.json.
Json plan_to_json(const RunPlan& plan, const RunOptions& options, const Communicator& communicator);

}  // namespace beadswim
