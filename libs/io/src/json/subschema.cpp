#include "subschema.hpp"

#include <initializer_list>

namespace beadswim {
namespace {

/// Branches of an if/then/else of a schema that apply to a value. Both are true if it is unknown which branch
/// applies, because the value is missing or because the condition concerns more than the type of the value.
struct Branches {
  bool then_taken = true;
  bool else_taken = true;
};

Branches branches(const Json& condition, const Json* value) {
  if (!value || !condition.contains("type")) return {};
  bool met = condition["type"] == value->type_name();
  for (const auto& [keyword, required] : condition.items()) {
    if (keyword == "type") continue;
    if (keyword != "required") return {};
    for (const Json& key : required) met = met && value->contains(key.get<std::string>());
  }
  return {met, !met};
}

/// Adds a schema to `found`, and all its parts that apply to the same value: the target of $ref, and the
/// parts of allOf, anyOf, oneOf and if/then/else.
void add_expanded(const Json& root, const Json& schema, const Json* value, Subschemas& found) {
  if (!schema.is_object()) return;
  if (const auto reference = schema.find("$ref"); reference != schema.end()) {
    const std::string pointer = reference->get<std::string>().substr(1);  // without '#'
    return add_expanded(root, root.at(Json::json_pointer(pointer)), value, found);
  }
  found.push_back(&schema);
  for (const char* keyword : {"allOf", "anyOf", "oneOf"}) {
    if (!schema.contains(keyword)) continue;
    for (const Json& part : schema[keyword]) add_expanded(root, part, value, found);
  }
  if (!schema.contains("if")) return;
  const Branches taken = branches(schema["if"], value);
  if (taken.then_taken && schema.contains("then")) add_expanded(root, schema["then"], value, found);
  if (taken.else_taken && schema.contains("else")) add_expanded(root, schema["else"], value, found);
}

/// Returns the subschema that `schema` contains for a member or element of the value, or nullptr if there is
/// none.
const Json* entry_for(const Json& schema, const std::string& key) {
  if (schema.contains("properties") && schema["properties"].contains(key)) return &schema["properties"][key];
  if (schema.contains("additionalProperties")) return &schema["additionalProperties"];
  if (schema.contains("items")) return &schema["items"];
  return nullptr;
}

}  // namespace

Subschemas document_schemas(const Json& root, const Json& document) {
  Subschemas found;
  add_expanded(root, root, &document, found);
  return found;
}

Subschemas member_schemas(const Json& root, const Subschemas& parents, const std::string& key,
                          const Json* value) {
  Subschemas found;
  for (const Json* parent : parents) {
    if (const Json* entry = entry_for(*parent, key)) add_expanded(root, *entry, value, found);
  }
  return found;
}

const Json* find_keyword(const Subschemas& schemas, const std::string& keyword) {
  for (const Json* schema : schemas) {
    if (schema->contains(keyword)) return &(*schema)[keyword];
  }
  return nullptr;
}

std::vector<std::string> property_names(const Subschemas& schemas) {
  std::vector<std::string> names;
  for (const Json* schema : schemas) {
    if (!schema->contains("properties")) continue;
    for (const auto& [name, entry] : (*schema)["properties"].items()) names.push_back(name);
  }
  return names;
}

}  // namespace beadswim
