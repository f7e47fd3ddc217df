#pragma once

#include <span>

#include "beadswim/documents/layout_document.hpp"
#include "run_loop.hpp"

namespace beadswim {

/// The run record; whole on rank 0. Collective.
RunRecord make_record(const RunParts& parts, const LayoutDocument& layout, const RunOutcome& outcome);

/// Returns the numbers of a run in any coherent units; `speed`: the largest of any bead.
DimensionlessNumbers dimensionless_numbers(std::span<const SwimmerType> types, double speed,
                                           double kinematic_viscosity, double period);

}  // namespace beadswim
