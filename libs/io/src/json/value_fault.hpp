#pragma once

#include <string>
#include <vector>

#include "beadswim/io/document_fault.hpp"
#include "beadswim/io/json.hpp"

namespace beadswim {

/// What valijson says of one failed constraint.
struct SchemaFailure {
  std::vector<std::string> path;  ///< keys and indices from the root to the value
  std::string description;        ///< valijson's words
};

/// Faults in words for users: one a place, with the bad value, what the schema allows there and the nearest
/// valid name. valijson repeats each failure for every ancestor; those echoes are left out.
std::vector<DocumentFault> explain_failures(const std::vector<SchemaFailure>& failures, const Json& schema,
                                            const Json& document);

}  // namespace beadswim
