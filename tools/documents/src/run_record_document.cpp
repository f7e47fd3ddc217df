#include "beadswim/documents/run_record_document.hpp"

#include "beadswim/documents/layout_document.hpp"
#include "beadswim/io/fields_json.hpp"
#include "beadswim/io/schema.hpp"
#include "units_json.hpp"

namespace beadswim {
RunRecord run_record_from_json(const Json& document, const std::string& source) {
  validate_json(document, "run", source);
  RunRecord record = document.get<RunRecord>();
  if (document.contains("scene")) record.scene = scene_from_json(document["scene"], record.units, source);
  return record;
}

RunRecord read_run_record(const std::string& path) {
  const std::string source = path == "-" ? "standard input" : path;
  return run_record_from_json(parse_json(read_text(path), source), source);
}

Json run_record_to_json(const RunRecord& record, RecordProvenance provenance) {
  Json document{{"schema", "beadswim/run/1"}};
  add_fields(document, record);
  if (record.scene) document["scene"] = scene_to_json(*record.scene);
  if (provenance == RecordProvenance::left_out) {
    document.erase("cost");
    document.erase("provenance");
  }
  return document;
}

}  // namespace beadswim
