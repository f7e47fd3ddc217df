#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "beadswim/compare/comparison.hpp"
#include "beadswim/documents/run_record_document.hpp"
#include "beadswim/io/fields_json.hpp"

// Result of a comparison (schemas/verdict.schema.json).

namespace beadswim {

/// Total cost of the compared runs.
struct VerdictCost {
  double wall_seconds = 0;
  double core_seconds = 0;
  std::int64_t cell_updates = 0;

  static void visit_fields(auto&& visit, auto& cost) {
    visit("wall_seconds", cost.wall_seconds);
    visit("core_seconds", cost.core_seconds);
    visit("cell_updates", cost.cell_updates);
  }
};

/// Rows of a comparison, and the method that decides the verdict.
struct VerdictDocument {
  std::string decided_by;  ///< method whose rows decide the verdict
  std::vector<ComparisonRow> rows;
  std::optional<VerdictCost> cost;
};

/// Returns the sum over all runs; nullopt if a record has no cost.
std::optional<VerdictCost> total_cost(std::span<const std::optional<RunCost>> runs);

/// Converts JSON after validation against the schema. Throws InputError, which names `source` and place.
VerdictDocument verdict_from_json(const Json& json, const std::string& source);

/// Returns the document as JSON. "pass" is the verdict of the rows; an infinite relative error becomes null.
Json verdict_to_json(const VerdictDocument& document);

}  // namespace beadswim
