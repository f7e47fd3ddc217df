#include "beadswim/documents/run_record_document.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "beadswim/io/schema.hpp"
#include "domain_json.hpp"
#include "units_json.hpp"

namespace beadswim {
namespace {

constexpr std::array<std::pair<RunStatus, std::string_view>, 5> status_names{{
    {RunStatus::finished, "finished"},
    {RunStatus::stopped_speed, "stopped-speed"},
    {RunStatus::stopped_time, "stopped-time"},
    {RunStatus::stopped_signal, "stopped-signal"},
    {RunStatus::failed, "failed"},
}};

}  // namespace

std::string name_of(RunStatus status) {
  return std::string(
      std::ranges::find(status_names, status, [](const auto& entry) { return entry.first; })->second);
}

static void to_json(Json& json, RunStatus status) {
  json = name_of(status);
}
static void from_json(const Json& json, RunStatus& status) {
  status = std::ranges::find(status_names, json.get<std::string>(), [](const auto& entry) {
             return entry.second;
           })->first;
}

RunRecord run_record_from_json(const Json& document, const std::string& source) {
  validate_json(document, "run", source);
  return document.get<RunRecord>();
}

RunRecord read_run_record(const std::string& path) {
  const std::string source = path == "-" ? "standard input" : path;
  return run_record_from_json(parse_json(read_text(path), source), source);
}

Json run_record_to_json(const RunRecord& record, RecordProvenance provenance) {
  Json document{{"schema", "beadswim/run/1"}};
  add_fields(document, record);
  if (provenance == RecordProvenance::left_out) {
    document.erase("cost");
    document.erase("provenance");
  }
  return document;
}

}  // namespace beadswim
