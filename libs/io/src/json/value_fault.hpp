#pragma once

#include <string>
#include <vector>

#include "beadswim/io/schema.hpp"

namespace beadswim {

/// A violated constraint of the schema, as the validator library valijson reports it.
struct SchemaFailure {
  std::vector<std::string> path;  ///< keys and indices from the root to the value
  std::string description;        ///< message of valijson
};

/// Returns explanations of the failures for users. Each fault contains the invalid value, the values that the
/// schema allows and the nearest valid name. valijson reports each failure again for all objects and arrays
/// that contain the value; these repetitions are omitted.
std::vector<DocumentFault> explain_failures(const std::vector<SchemaFailure>& failures, const Json& schema,
                                            const Json& document);

}  // namespace beadswim
