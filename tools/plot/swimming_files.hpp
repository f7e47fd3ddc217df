#pragma once

#include <string>
#include <vector>

#include "beadswim/documents/swimming_document.hpp"

namespace beadswim {

struct SourceDocument {
  std::string source;  ///< "FILE", or "FILE line N" of a file of several
  SwimmingDocument document;
};

/// The run records and predictions of a file, or of stdin for "-": one document, or JSON lines, one a line.
/// Throws InputError naming the source.
std::vector<SourceDocument> read_swimming_file(const std::string& path);

}  // namespace beadswim
