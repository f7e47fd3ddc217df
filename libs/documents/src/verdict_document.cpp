#include "beadswim/documents/verdict_document.hpp"

#include "beadswim/io/schema.hpp"

namespace beadswim {

std::optional<VerdictCost> total_cost(std::span<const std::optional<RunCost>> runs) {
  VerdictCost total;
  for (const std::optional<RunCost>& cost : runs) {
    if (!cost) return std::nullopt;
    total.wall_seconds += cost->wall_seconds;
    total.core_seconds += cost->core_seconds;
    total.cell_updates += cost->cell_updates.value_or(0);
  }
  return total;
}

VerdictDocument verdict_from_json(const Json& json, const std::string& source) {
  validate_json(json, "verdict", source);
  return json.get<VerdictDocument>();
}

Json verdict_to_json(const VerdictDocument& document) {
  Json json{{"schema", "beadswim/verdict/1"}, {"pass", verdict(document.rows)}};
  add_fields(json, document);
  return json;
}

}  // namespace beadswim
