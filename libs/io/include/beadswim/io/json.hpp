#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "beadswim/core/names.hpp"
#include "beadswim/core/temporary_file.hpp"

// Reading of strict JSON, and writing of JSON whose numbers are all finite.

// json_parse.cpp instantiates the members of the type Json once, which shortens the compilation of all files that use it.
extern template class nlohmann::basic_json<nlohmann::ordered_map>;

namespace beadswim {

/// JSON value whose objects keep their keys in the order in which they were added. Documents are written in
/// this order.
using Json = nlohmann::ordered_json;

/// Convert between JSON and an enumeration with a table of names (core/names.hpp). JSON contains the name.
template <NamedEnum Enum>
void to_json(Json& json, Enum value) {
  json = to_text(value);
}
template <NamedEnum Enum>
void from_json(const Json& json, Enum& value) {
  value = from_text<Enum>(json.get<std::string>());
}

/// Opens a file, or a copy of a pipe or of stdin if `path` is "-", to read it at any place. Throws InputError
/// if it cannot be read.
OpenFile open_input(const std::string& path);

/// Returns the text of a file, or of stdin if `path` is "-". Throws InputError if it cannot be read.
std::string read_text(const std::string& path);

/// Parses strict JSON: no duplicate keys, no NaN or infinity, no comments, no text after the document, at
/// most 200 levels of nesting. Throws InputError "source: line L, column C: ...", or "source:/json/pointer:
/// ..." for a duplicate key.
Json parse_json(const std::string& text, const std::string& source);

/// Returns "/key", the step of a JSON pointer, with the key escaped according to RFC 6901.
inline std::string pointer_step(const std::string& key) {
  return (Json::json_pointer() / key).to_string();
}

/// Returns the text of a document, which ends with a newline. Doubles are written with enough digits to be
/// read back unchanged. If a number is non-finite, throws SolverError with the JSON pointer to the number.
/// nlohmann-json would write null instead.
std::string dump_json(const Json& document);

/// Returns the text of a document on one line, for streams with one document per line. Throws SolverError if
/// a number is non-finite.
std::string dump_json_line(const Json& document);

/// Writes a text file completely or not at all: writes a temporary file in the same folder, flushes it to the
/// disk and renames it. Writes to stdout if `path` is "-". Throws InputError if the file cannot be created,
/// and SolverError if it cannot be written.
void write_text(const std::string& path, const std::string& text);

}  // namespace beadswim
