#include "schema_name.hpp"

#include <fmt/core.h>

#include <array>
#include <optional>
#include <regex>

#include "beadswim/core/error.hpp"
#include "beadswim/core/names.hpp"
#include "json_pointer.hpp"

namespace beadswim {
namespace {

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

}  // namespace

void check_schema_name(const Json& document, const std::string& expected, const std::string& source) {
  if (!document.is_object()) {
    throw InputError(source, fmt::format("the JSON document is {} {}; give an object with \"schema\": \"{}\"",
                                         document.is_array() ? "an" : "a", document.type_name(), expected));
  }
  const auto entry = document.find("schema");
  if (entry == document.end()) {
    for (const auto& [key, value] : document.items()) {
      if (!nearest_name(key, {"schema"}).empty())
        throw InputError(source + ":" + pointer_step(key), "unknown key; did you mean \"schema\"?");
    }
    throw InputError(
        source,
        fmt::format(
            "the document lacks the key \"schema\"; add \"schema\": \"{}\" if the document has this format",
            expected));
  }
  const std::string place = source + ":/schema";
  const auto found = entry->is_string() ? parse_schema_name(entry->get<std::string>()) : std::nullopt;
  if (!found)
    throw InputError(
        place, fmt::format("{}: the value of the key \"schema\" must be \"{}\"", entry->dump(), expected));
  const SchemaName wanted = parse_schema_name(expected).value();
  if (found->kind != wanted.kind || found->version != wanted.version) {
    throw InputError(place, disagreement(*found, wanted, entry->get<std::string>()));
  }
}

}  // namespace beadswim
