#include "beadswim/documents/verdict_document.hpp"

#include <cmath>

namespace beadswim {
namespace {

Json json_of(const ComparisonRow& row) {
  Json json = {{"quantity", name_of(row.quantity)}};
  if (row.arm) json["arm"] = *row.arm;
  json["run_file"] = row.run_source;
  json["swimmer"] = row.swimmer;
  json["run"] = row.run;
  json["reference_file"] = row.reference_source;
  json["reference"] = row.reference;
  json["method"] = row.method;
  json["usable"] = row.usable;
  json["relative_error"] = std::isinf(row.relative_error) ? Json(nullptr) : Json(row.relative_error);
  json["tolerance"] = row.tolerance;
  json["pass"] = row.pass;
  json["decides"] = row.decides;
  return json;
}

Json json_of(const std::optional<VerdictCost>& cost) {
  if (!cost) return nullptr;
  return {{"wall_seconds", cost->wall_seconds},
          {"core_seconds", cost->core_seconds},
          {"cell_updates", cost->cell_updates}};
}

}  // namespace

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

Json verdict_to_json(const VerdictDocument& document) {
  Json rows = Json::array();
  for (const ComparisonRow& row : document.rows) rows.push_back(json_of(row));
  return {{"schema", "beadswim/verdict/1"},
          {"pass", verdict(document.rows)},
          {"decided_by", document.decided_by},
          {"rows", rows},
          {"cost", json_of(document.cost)}};
}

}  // namespace beadswim
