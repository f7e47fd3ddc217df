#pragma once

#include <span>

#include "beadswim/documents/layout_document.hpp"
#include "run_loop.hpp"

namespace beadswim {

/// Returns the run record. It is complete on rank 0 only. Collective.
RunRecord make_record(const RunParts& parts, const LayoutDocument& layout, const RunOutcome& outcome);

/// Returns the warnings that are known after the run, complete on rank 0 only.
std::vector<RunWarning> warnings_after_run(const RunParts& parts);

/// Returns the dimensionless numbers of a run, except the Mach number. `speed`: largest bead speed. `period`:
/// base period. All arguments must have the same system of units.
DimensionlessNumbers dimensionless_numbers(std::span<const SwimmerType> types, double speed,
                                           double kinematic_viscosity, double period);

}  // namespace beadswim
