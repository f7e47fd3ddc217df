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

  BEADSWIM_FIELDS(program, member, reason, (study, omitted_if_none))
};

/// Returns the document as a line of JSON.
std::string failure_line(const FailureDocument& failure);

/// Throws SolverError if `failed` of the `count` parts of a stream ended with failures. `lack`: the parts and
/// what they lack, such as "layouts have no prediction".
void require_no_failures(int failed, int count, const std::string& lack);

/// Returns true if a JSON document is a failure, by its schema name.
bool is_failure(const Json& document);

}  // namespace beadswim
