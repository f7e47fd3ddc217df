#include "beadswim/documents/failure_document.hpp"

namespace beadswim {
namespace {

constexpr const char* schema_name = "beadswim/failure/1";

}  // namespace

Json failure_to_json(const FailureDocument& failure) {
  Json json{{"schema", schema_name},
            {"status", "failed"},
            {"program", failure.program},
            {"member", failure.member},
            {"reason", failure.reason}};
  if (!failure.study.is_null()) json["study"] = failure.study;
  return json;
}

bool is_failure(const Json& document) {
  return document.is_object() && document.value("schema", Json()) == schema_name;
}

}  // namespace beadswim
