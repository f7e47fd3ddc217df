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
  return {.decided_by = json.at("decided_by"),
          .rows = json.at("rows"),
          .cost = json.at("cost").get<std::optional<VerdictCost>>(),
          .scene_differences = json.value("scene_differences", std::vector<SceneDifference>()),
          .study = json.value("study", Json())};
}

Json verdict_to_json(const VerdictDocument& document) {
  Json json{{"schema", "beadswim/verdict/1"},
            {"pass", verdict(document.rows)},
            {"decided_by", document.decided_by},
            {"rows", document.rows},
            {"scene_differences", document.scene_differences},
            {"cost", document.cost}};
  if (!document.study.is_null()) json["study"] = document.study;
  return json;
}

}  // namespace beadswim
