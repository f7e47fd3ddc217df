#pragma once

#include "beadswim/io/document_fault.hpp"
#include "beadswim/io/json.hpp"
#include "beadswim/swimmers/swimmer_type.hpp"

// Swimmer types of any shape as JSON, the types of layouts of version 2 (schemas/layout-2.schema.json). The
// JSON must have been validated against this schema. Beads, bonds and angles are numbered from 1 in JSON.

namespace beadswim {

/// Converts a type. Rest lengths and rest angles that the JSON omits are those of the beads at rest. Numbers
/// of beads, bonds and angles may be wrong; check_layout() reports them.
SwimmerType shape_from_json(const Json& json);
Json shape_to_json(const SwimmerType& type);

/// Returns faults of a layout of version 2 that its schema does not know: swimmers with axis and orientation,
/// and drives of bonds without or with both of tension and rest length.
std::vector<DocumentFault> shape_faults(const Json& layout);

/// Returns a copy of `driving` in which the members that `json` contains are replaced.
Driving override_shape_driving(Driving driving, const Json& json);

/// Returns the members of a driving that differ from `of_type`, the driving of the swimmer's type.
Json shape_driving_difference(const Driving& driving, const Driving& of_type);

}  // namespace beadswim
