#pragma once

#include <string>

#include "beadswim/io/json.hpp"
#include "beadswim/plan/run_plan.hpp"
#include "command_line/options.hpp"

namespace beadswim {

/// For people: the cheapest runs for their error, and every model or resolution that is refused with its
/// reason.
std::string plan_table(const RunPlan& plan, const RunOptions& asked, const Communicator& communicator);

/// schemas/plan.schema.json: every run.
Json plan_to_json(const RunPlan& plan, const RunOptions& asked, const Communicator& communicator);

}  // namespace beadswim
