#include "beadswim/documents/verdict_document.hpp"

#include <cmath>
#include <limits>

#include "beadswim/io/schema.hpp"

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

/// What json_of wrote.
ComparisonRow row_from_json(const Json& json) {
  ComparisonRow row;
  row.quantity = *quantity_named(json.at("quantity").get<std::string>());
  if (json.contains("arm")) row.arm = json.at("arm").get<int>();
  row.run_source = json.at("run_file").get<std::string>();
  row.swimmer = json.at("swimmer").get<int>();
  row.run = json.at("run").get<double>();
  row.reference_source = json.at("reference_file").get<std::string>();
  row.reference = json.at("reference").get<double>();
  row.method = json.at("method").get<std::string>();
  row.usable = json.at("usable").get<bool>();
  const Json& error = json.at("relative_error");
  row.relative_error = error.is_null() ? std::numeric_limits<double>::infinity() : error.get<double>();
  row.tolerance = json.at("tolerance").get<double>();
  row.pass = json.at("pass").get<bool>();
  row.decides = json.at("decides").get<bool>();
  return row;
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

VerdictDocument verdict_from_json(const Json& json, const std::string& source) {
  validate_json(json, "verdict", source);
  VerdictDocument document{json.at("decided_by").get<std::string>(), {}, {}};
  for (const Json& row : json.at("rows")) document.rows.push_back(row_from_json(row));
  const Json& cost = json.at("cost");
  if (cost.is_null()) return document;
  document.cost = {.wall_seconds = cost.at("wall_seconds").get<double>(),
                   .core_seconds = cost.at("core_seconds").get<double>(),
                   .cell_updates = cost.at("cell_updates").get<std::int64_t>()};
  return document;
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
