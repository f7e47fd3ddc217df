#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "beadswim/compare/comparison.hpp"
#include "beadswim/documents/run_record_document.hpp"
#include "beadswim/io/fields_json.hpp"
#include "beadswim/scene/scene_differences.hpp"

// Result of a comparison of runs with references (schemas/verdict.schema.json).

namespace beadswim {

/// Total cost of the compared runs.
struct VerdictCost {
  double wall_seconds = 0;
  double core_seconds = 0;
  std::int64_t cell_updates = 0;

  BEADSWIM_FIELDS(wall_seconds, core_seconds, cell_updates)
};

/// Rows of a comparison, the method that determines the verdict, and the allowed differences of the scenes.
struct VerdictDocument {
  std::string decided_by;  ///< method whose rows determine the verdict
  std::vector<ComparisonRow> rows;
  std::optional<VerdictCost> cost;
  std::vector<SceneDifference> scene_differences{};
  Json study{};  ///< study of the first run (layout_document.hpp); null: none

  BEADSWIM_FIELDS(decided_by, rows, scene_differences, cost, (study, omitted_if_none))
};

/// Returns the sum of the costs of all runs; nullopt if the cost of a run is not known.
std::optional<VerdictCost> total_cost(std::span<const std::optional<RunCost>> runs);

/// Converts a JSON document to a verdict after validation against the schema. Throws InputError if the
/// document is invalid; the message contains `source` and the place in the document.
VerdictDocument verdict_from_json(const Json& json, const std::string& source);

/// Returns the verdict document as JSON. "pass" is the verdict over all rows; an infinite relative error
/// becomes null.
Json verdict_to_json(const VerdictDocument& document);

}  // namespace beadswim
