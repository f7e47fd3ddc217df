#include "beadswim/io/schema.hpp"

#include <fmt/core.h>

#include <array>
#include <map>
#include <optional>
#include <regex>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>

#include "beadswim/core/names.hpp"
#include "embedded_schemas.hpp"
#include "value_fault.hpp"

namespace beadswim {
namespace {

// --- Name of the schema that a document states

/// Parts of a schema name "beadswim/KIND/VERSION".
struct SchemaName {
  std::string kind;
  int version = 0;
};

std::optional<SchemaName> parse_schema_name(const std::string& text) {
  static const std::regex form("beadswim/([a-z-]+)/([0-9]{1,6})");
  std::smatch part;
  if (!std::regex_match(text, part, form)) return std::nullopt;
  return SchemaName{part[1], std::stoi(part[2])};
}

/// Returns what a document of the kind is, and which program writes it.
std::string in_words(const std::string& kind) {
  constexpr std::array kinds{
      std::pair{"layout", "a layout (beadswim-layout)"},
      std::pair{"prediction", "a prediction (beadswim-theory)"},
      std::pair{"run", "a run record (beadswim-run), without positions, which are in the trajectory (.h5md)"},
      std::pair{"verdict", "a verdict (beadswim-compare)"}};
  for (const auto& [name, words] : kinds)
    if (kind == name) return words;
  return fmt::format("a document of the kind \"{}\"", kind);
}

std::string disagreement(const SchemaName& found, const SchemaName& wanted, const std::string& found_text) {
  if (found.kind != wanted.kind) {
    return fmt::format("the document is {}; give {}", in_words(found.kind), in_words(wanted.kind));
  }
  if (found.version > wanted.version) {
    return fmt::format(
        "the schema \"{}\" is newer than this program, which reads version {}; update Beadswim", found_text,
        wanted.version);
  }
  return fmt::format(
      "the schema \"{}\" has a version that this program cannot read; give a document of version {}",
      found_text, wanted.version);
}

/// Throws InputError if the key "schema" of the document does not have the value `expected`, for example
/// "beadswim/layout/1". The message then states the actual kind of the document, or that its version is not
/// the version that this program reads.
void check_schema_name(const Json& document, const std::string& expected, const std::string& source) {
  if (!document.is_object()) {
    throw InputError(source, "the JSON document is {} {}; give an object with \"schema\": \"{}\"",
                     document.is_array() ? "an" : "a", document.type_name(), expected);
  }
  const auto entry = document.find("schema");
  if (entry == document.end()) {
    for (const auto& [key, value] : document.items()) {
      if (!nearest_name(key, {"schema"}).empty())
        throw InputError(source + ":" + pointer_step(key), "unknown key; did you mean \"schema\"?");
    }
    throw InputError(
        source,
        "the document lacks the key \"schema\"; add \"schema\": \"{}\" if the document has this format",
        expected);
  }
  const std::string place = source + ":/schema";
  const auto found = entry->is_string() ? parse_schema_name(entry->get<std::string>()) : std::nullopt;
  if (!found)
    throw InputError(place, "{}: the value of the key \"schema\" must be \"{}\"", entry->dump(), expected);
  const SchemaName wanted = parse_schema_name(expected).value();
  if (found->kind != wanted.kind || found->version != wanted.version) {
    throw InputError(place, disagreement(*found, wanted, entry->get<std::string>()));
  }
}

// --- Faults of the contents

/// A schema as JSON and in the compiled form of valijson.
struct Rules {
  explicit Rules(const std::string& schema) : text(Json::parse(schema)) {
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
  return known.try_emplace(name, embedded_schemas().at(name)).first->second;
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

constexpr std::size_t max_faults_shown = 20;

std::string place(const std::string& source, const DocumentFault& fault) {
  return fault.pointer.empty() ? source : source + ":" + fault.pointer;
}

}  // namespace

void validate_json(const Json& document, const std::string& schema_name, const std::string& source) {
  const Rules& rules = rules_of(schema_name);
  check_schema_name(document, rules.text.at("properties").at("schema").at("const").get<std::string>(),
                    source);
  const auto found = failures(nlohmann::json(document), rules.compiled);
  throw_if_faulty(source, explain_failures(found, rules.text, document));
}

void throw_if_faulty(const std::string& source, const std::vector<DocumentFault>& faults) {
  if (faults.empty()) return;
  std::string text = faults.front().message;
  for (std::size_t i = 1; i < faults.size() && i < max_faults_shown; ++i) {
    text += fmt::format("\n{}: {}", place(source, faults[i]), faults[i].message);
  }
  if (faults.size() > max_faults_shown) {
    text +=
        fmt::format("\n{}: at least {} more faults are not listed", source, faults.size() - max_faults_shown);
  }
  throw InputError(place(source, faults.front()), text);
}

}  // namespace beadswim
