#pragma once

#include <string>
#include <vector>

#include "beadswim/documents/swimming_document.hpp"
#include "beadswim/io/json.hpp"

namespace beadswim {

/// A document and what messages call it: "FILE", or "FILE line N" of a file of several.
struct SourceJson {
  std::string source;
  Json json;
};

/// "beadswim/run/1"; empty if the document does not say what it is.
std::string schema_of(const Json& document);

/// The documents of a file, or of stdin for "-": one, or JSON lines, one a line. Throws InputError naming the
/// source, also if there is none; `wanted` says what should be there.
std::vector<SourceJson> read_json_documents(const std::string& path, const std::string& wanted);

struct SourceDocument {
  std::string source;
  SwimmingDocument document;
};

/// The run records and predictions of such a file. Throws InputError naming the source.
std::vector<SourceDocument> read_swimming_file(const std::string& path);

}  // namespace beadswim
