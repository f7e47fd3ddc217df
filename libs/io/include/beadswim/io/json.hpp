#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "beadswim/core/names.hpp"

// Strict JSON in, finite JSON out.

namespace beadswim {

/// Keeps keys in the order of writing, so that documents read as their specification does.
using Json = nlohmann::ordered_json;

/// An enumeration with a table of names stands in JSON by name.
template <NamedEnum Enum>
void to_json(Json& json, Enum value) {
  json = to_text(value);
}
template <NamedEnum Enum>
void from_json(const Json& json, Enum& value) {
  value = from_text<Enum>(json.get<std::string>());
}

/// The whole text of a file, or of stdin for "-". Throws InputError naming the path.
std::string read_text(const std::string& path);

/// Parses strict JSON: no duplicate keys, no NaN or infinity, no comments, nothing after the document,
/// at most 200 levels.
/// Throws InputError "source: line L, column C: ...", or "source:/json/pointer: ..." for a duplicate key.
Json parse_json(const std::string& text, const std::string& source);

/// Text of a document, ending in a newline; doubles round-trip. Throws SolverError "source:/json/pointer"
/// if a number in it is not finite (nlohmann-json would write null).
std::string dump_json(const Json& document);

/// The same on one line, for streams of one document a line.
std::string dump_json_line(const Json& document);

/// Writes text whole or not at all: a temporary file beside `path`, fsync, rename. "-" is stdout.
void write_text(const std::string& path, const std::string& text);

}  // namespace beadswim
