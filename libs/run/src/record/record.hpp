#pragma once

#include <span>

#include "beadswim/documents/layout_document.hpp"
#include "run_loop.hpp"

namespace beadswim {

/// Returns the run record. `late`: warnings that are known after the run. The record is complete on rank 0
/// only. Collective.
RunRecord make_record(const RunParts& parts, const LayoutDocument& layout, const RunOutcome& outcome,
                      const std::vector<RunWarning>& late);

/// Returns the dimensionless numbers of a run, except the Mach number. `speed`: largest bead speed. `period`:
/// base period. All arguments must have the same system of units.
DimensionlessNumbers dimensionless_numbers(std::span<const SwimmerType> types, double speed,
                                           double kinematic_viscosity, double period);

}  // namespace beadswim
