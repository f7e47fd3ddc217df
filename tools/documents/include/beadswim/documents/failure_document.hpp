#pragma once

#include <string>

#include "beadswim/io/fields_json.hpp"

namespace beadswim {

/// A layout of a stream that a program could not treat (schemas/failure.schema.json).
struct FailureDocument {
  std::string program;
  int member = 1;  ///< position of the layout in the stream, from 1
  std::string reason;
  Json study{};  ///< study of the layout (layout_document.hpp)
};

/// Returns the document as JSON.
Json failure_to_json(const FailureDocument& failure);

/// Returns true if a JSON document is a failure, by its schema name.
bool is_failure(const Json& document);

}  // namespace beadswim
