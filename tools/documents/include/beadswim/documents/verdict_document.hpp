#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "beadswim/compare/comparison.hpp"
#include "beadswim/documents/run_record_document.hpp"
#include "beadswim/io/fields_json.hpp"

// What a comparison found (schemas/verdict.schema.json).

namespace beadswim {

/// What the compared runs cost together.
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

struct VerdictDocument {
  std::string decided_by;  ///< the method whose rows decide
  std::vector<ComparisonRow> rows;
  std::optional<VerdictCost> cost;
};

/// The sum over runs; none if a run's record leaves its cost out.
std::optional<VerdictCost> total_cost(std::span<const std::optional<RunCost>> runs);

/// Throws InputError naming `source` and place.
VerdictDocument verdict_from_json(const Json& json, const std::string& source);

/// "pass" is the verdict of the rows; an infinite relative error is null.
Json verdict_to_json(const VerdictDocument& document);

}  // namespace beadswim
