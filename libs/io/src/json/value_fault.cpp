#include "value_fault.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <optional>

#include "beadswim/core/joined.hpp"
#include "beadswim/core/names.hpp"
#include "subschema.hpp"

namespace beadswim {
namespace {

/// Returns true if the failure of an object or array only repeats the failure of a value inside it. The
/// validator library valijson reports such repetitions.
bool is_echo(const SchemaFailure& failure) {
  return failure.description.starts_with("Failed to validate");
}

/// Returns the name in single quotes in valijson's description of a missing key.
std::string quoted_name(const std::string& description) {
  const std::size_t start = description.find('\'') + 1;
  return description.substr(start, description.rfind('\'') - start);
}

std::string echo_value(const Json& value) {
  constexpr std::size_t max_length = 60;
  const std::string text = value.dump();
  return text.size() <= max_length ? text : text.substr(0, max_length) + "...";
}

std::string allowed_range(const Subschemas& schemas) {
  const std::initializer_list<std::pair<const char*, const char*>> bounds{
      {"exclusiveMinimum", "greater than "},
      {"minimum", "at least "},
      {"exclusiveMaximum", "less than "},
      {"maximum", "at most "}};
  std::vector<std::string> parts;
  for (const auto& [keyword, words] : bounds) {
    if (const Json* bound = find_keyword(schemas, keyword)) parts.push_back(words + bound->dump());
  }
  return fmt::format("the value must be {}", joined(parts, " and "));
}

std::string allowed_count(const Subschemas& schemas, const Json& value) {
  const Json* least = find_keyword(schemas, "minItems");
  const Json* most = find_keyword(schemas, "maxItems");
  const std::string allowed = least && most && *least == *most ? "exactly " + least->dump()
                              : least && value.size() < least->get<std::size_t>()
                                  ? "at least " + least->dump()
                                  : "at most " + most->dump();
  return fmt::format("the array has {} elements, but {} are needed", value.size(), allowed);
}

/// Returns ", or an object ..." if the schema allows an object in place of a name, otherwise an empty text.
std::string allowed_object(const Subschemas& schemas) {
  const Json* condition = find_keyword(schemas, "if");
  if (condition == nullptr || *condition != Json{{"type", "object"}}) return "";
  const Json* examples = find_keyword(schemas, "examples");
  return examples ? fmt::format(", or an object such as {}", examples->front().dump()) : ", or an object";
}

std::string allowed_names(const Subschemas& schemas, const Json& value) {
  const Json& names = *find_keyword(schemas, "enum");
  const std::string what = names.size() == 1 ? names[0].dump() : "one of " + names.dump();
  const std::string text = fmt::format("the value must be {}{}", what, allowed_object(schemas));
  if (!value.is_string()) return text;
  return text + format_suggestion(value.get<std::string>(), names.get<std::vector<std::string>>());
}

std::string allowed_type(const Subschemas& schemas, const Json& value) {
  const Json& type = *find_keyword(schemas, "type");
  const std::string names =
      type.is_array() ? joined(type.get<std::vector<std::string>>(), " or ") : type.get<std::string>();
  return fmt::format("the value must be of type {}, not {}", names, value.type_name());
}

/// Describes the values that the schema allows in place of an invalid value.
std::string allowed(const SchemaFailure& failure, const Subschemas& schemas, const Json& value) {
  const std::string& message = failure.description;
  if (message.starts_with("Value type") && find_keyword(schemas, "type")) return allowed_type(schemas, value);
  if (message.starts_with("Failed to match against any enum") && find_keyword(schemas, "enum")) {
    return allowed_names(schemas, value);
  }
  if (message.starts_with("Failed to match expected value") && find_keyword(schemas, "const")) {
    return "must be " + find_keyword(schemas, "const")->dump();
  }
  if (message.starts_with("Expected number")) return allowed_range(schemas);
  if (message.starts_with("Array should contain")) return allowed_count(schemas, value);
  return message;
}

/// Returns " (description)" from the schema, or an empty text if it has no description.
std::string meaning(const Subschemas& schemas) {
  const Json* description = find_keyword(schemas, "description");
  return description ? fmt::format(" ({})", description->get<std::string>()) : "";
}

DocumentFault explain_value(const SchemaFailure& failure, const std::string& pointer,
                            const Subschemas& schemas, const Json& value) {
  const bool is_about_length = failure.description.starts_with("Array should contain");
  const std::string echo = is_about_length ? "" : echo_value(value) + ": ";
  return {pointer, echo + allowed(failure, schemas, value) + meaning(schemas)};
}

/// All failures at one place of the document.
struct Place {
  std::vector<std::string> path;
  bool has_unknown_keys = false;
  std::vector<std::string> missing_keys;
  std::optional<SchemaFailure> value;
};

void add_failure(const SchemaFailure& failure, Place& place) {
  if (failure.description.starts_with("Object contains a property")) {
    place.has_unknown_keys = true;
  } else if (failure.description.starts_with("Missing required property")) {
    place.missing_keys.push_back(quoted_name(failure.description));
  } else if (!place.value || failure.description.starts_with("Value type")) {
    place.value = failure;  // a wrong type is the cause of all other failures of a value
  }
}

/// Groups failures by their place in the document, in the order of the first failure of each place. Omits the
/// failures of objects and arrays that only repeat the failure of a value inside them.
std::vector<Place> gather_by_place(const std::vector<SchemaFailure>& failures) {
  std::vector<Place> places;
  std::map<std::vector<std::string>, std::size_t> index;
  for (const SchemaFailure& failure : failures) {
    if (is_echo(failure)) continue;
    const auto [entry, is_new] = index.try_emplace(failure.path, places.size());
    if (is_new) places.emplace_back().path = failure.path;
    add_failure(failure, places[entry->second]);
  }
  return places;
}

/// Adds one fault per unknown key of an object. Returns the keys that were probably intended.
std::vector<std::string> explain_unknown_keys(const std::string& pointer, const Subschemas& schemas,
                                              const Json& object, std::vector<DocumentFault>& faults) {
  const std::vector<std::string> names = property_names(schemas);
  // Absent keys are suggested first: a key that the object already contains was probably not intended.
  std::vector<std::string> absent, suggestions;
  std::ranges::copy_if(names, std::back_inserter(absent),
                       [&](const std::string& name) { return !object.contains(name); });
  for (const auto& [key, value] : object.items()) {
    if (std::ranges::find(names, key) != names.end()) continue;
    const std::vector<std::string>& candidates = nearest_name(key, absent).empty() ? names : absent;
    suggestions.push_back(nearest_name(key, candidates));
    faults.push_back(
        {pointer + pointer_step(key), fmt::format("unknown key{} Keys allowed here: {}",
                                                  format_suggestion(key, candidates), joined(names, ", "))});
  }
  return suggestions;
}

}  // namespace

std::vector<DocumentFault> explain_failures(const std::vector<SchemaFailure>& failures, const Json& schema,
                                            const Json& document) {
  std::vector<DocumentFault> faults;
  for (const Place& place : gather_by_place(failures)) {
    const Json* value = &document;
    Subschemas schemas = document_schemas(schema, document);
    std::string pointer;
    for (const std::string& key : place.path) {
      value = &(value->is_array() ? value->at(std::stoul(key)) : value->at(key));
      schemas = member_schemas(schema, schemas, key, value);
      pointer += pointer_step(key);
    }
    if (place.value) faults.push_back(explain_value(*place.value, pointer, schemas, *value));
    std::vector<std::string> suggestions;
    if (place.has_unknown_keys) suggestions = explain_unknown_keys(pointer, schemas, *value, faults);
    for (const std::string& key : place.missing_keys) {
      // A misspelt required key is both unknown and missing. It is reported once, as unknown.
      if (std::ranges::find(suggestions, key) != suggestions.end()) continue;
      const std::string what = meaning(member_schemas(schema, schemas, key, nullptr));
      faults.push_back({pointer, fmt::format("the object lacks the key \"{}\"{}", key, what)});
    }
  }
  return faults;
}

}  // namespace beadswim
