#pragma once

#include <string>
#include <vector>

#include "beadswim/io/json.hpp"
#include "beadswim/plan/run_plan.hpp"

namespace beadswim {

/// Formats the plan as text. A table lists all possible runs with mobilities, and those lattice runs for
/// which no cheaper run has a similar or smaller expected error. Below the table, the text states the meaning
/// of the errors, and lists the impossible runs with their reasons ("refused"), properties of the scene that
/// make runs inaccurate or impossible ("hard"), and proposed layouts ("propose"). `layout`: file of the
/// layout, for the commands that make proposed layouts.
std::string plan_table(const RunPlan& plan, const std::string& layout);

/// Returns the head of the table, two lines. `indent`: begin of both.
std::string plan_head(const std::string& indent = "");

/// Returns the row of a run in the table. `remark`: end of the row.
std::string plan_row(const RunPlan& plan, const PlannedRun& run, const std::string& remark);

/// Returns the reasons why runs are refused, each after the settings of such a run. Runs whose reasons differ
/// only in numbers share one entry.
std::vector<std::string> refusals(const RunPlan& plan);

/// Returns a size as text, such as "1.2 GB".
std::string size_text(double bytes);

/// Returns all runs of the plan as a document that follows schemas/plan.schema.json, without provenance.
Json plan_to_json(const RunPlan& plan, const std::string& layout);

}  // namespace beadswim
