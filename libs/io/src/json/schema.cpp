#include "beadswim/io/schema.hpp"

#include <map>
#include <stdexcept>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>

#include "embedded_schemas.hpp"
#include "schema_name.hpp"
#include "value_fault.hpp"

namespace beadswim {
namespace {

/// A schema as JSON and in the compiled form of valijson.
struct Rules {
  explicit Rules(std::string_view schema) : text(Json::parse(schema)) {
    const nlohmann::json unordered(text);
    valijson::SchemaParser().populateSchema(valijson::adapters::NlohmannJsonAdapter(unordered), compiled);
  }

  Json text;
  valijson::Schema compiled;
};

/// Returns the rules of a schema. Compiles each schema only once, because compilation takes longer than the
/// validation of a document.
const Rules& rules_of(const std::string& name) {
  static std::map<std::string, Rules> known;
  if (const auto found = known.find(name); found != known.end()) return found->second;
  for (const EmbeddedSchema& schema : embedded_schemas()) {
    if (schema.name == name) return known.try_emplace(name, schema.text).first->second;
  }
  throw std::logic_error("no schema " + name + " is built in");
}

/// Returns the keys from the root of the document to the place of an error. valijson writes each key as
/// "[key]", after a first step "<root>", which is omitted.
std::vector<std::string> path_of(const valijson::ValidationResults::Error& error) {
  std::vector<std::string> path;
  for (const std::string& step : error.context) {
    if (step != "<root>") path.push_back(step.substr(1, step.size() - 2));
  }
  return path;
}

std::vector<SchemaFailure> failures(const nlohmann::json& document, const valijson::Schema& rules) {
  valijson::Validator validator(valijson::Validator::kStrongTypes);
  const valijson::adapters::NlohmannJsonAdapter target(document);
  std::vector<SchemaFailure> found;
  // Without an object for results, valijson stops at the first failure and is several times faster.
  if (validator.validate(rules, target, nullptr)) return found;
  valijson::ValidationResults results;
  validator.validate(rules, target, &results);
  for (const auto& error : results) found.push_back({path_of(error), error.description});
  return found;
}

}  // namespace

void validate_json(const Json& document, const std::string& schema_name, const std::string& source) {
  const Rules& rules = rules_of(schema_name);
  check_schema_name(document, rules.text.at("properties").at("schema").at("const").get<std::string>(),
                    source);
  const auto found = failures(nlohmann::json(document), rules.compiled);
  throw_if_faulty(source, explain_failures(found, rules.text, document));
}

}  // namespace beadswim
