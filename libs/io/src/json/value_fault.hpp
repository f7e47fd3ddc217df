#pragma once

#include <string>
#include <vector>

#include "beadswim/io/document_fault.hpp"
#include "beadswim/io/json.hpp"

namespace beadswim {

/// A constraint that failed in valijson.
struct SchemaFailure {
  std::vector<std::string> path;  ///< keys and indices from the root to the value
  std::string description;        ///< message of valijson
};

/// Explains failures to users. Each fault contains the invalid value, the values that the schema allows and
/// the nearest valid name. valijson repeats each failure for every ancestor; these repetitions are omitted.
std::vector<DocumentFault> explain_failures(const std::vector<SchemaFailure>& failures, const Json& schema,
                                            const Json& document);

}  // namespace beadswim
