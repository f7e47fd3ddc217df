#include "beadswim/documents/failure_document.hpp"

#include <fmt/core.h>

#include "beadswim/core/error.hpp"

namespace beadswim {
namespace {

constexpr const char* schema_name = "beadswim/failure/1";

}  // namespace

std::string failure_line(const FailureDocument& failure) {
  Json json{{"schema", schema_name}, {"status", "failed"}};
  add_fields(json, failure);
  return dump_json_line(json);
}

void require_no_failures(int failed, int count, const std::string& lack) {
  if (failed > 0)
    throw SolverError(fmt::format(
        "{} of {} {}: see the key \"reason\" of documents with \"status\": \"failed\"", failed, count, lack));
}

bool is_failure(const Json& document) {
  return document.is_object() && document.value("schema", Json()) == schema_name;
}

}  // namespace beadswim
