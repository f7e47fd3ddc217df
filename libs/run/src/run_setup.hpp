#pragma once

#include "beadswim/io/h5md.hpp"
#include "beadswim/run/run.hpp"

namespace beadswim {

/// Returns the constant data of the trajectory file: box, beads, layout and program version.
TrajectoryHeader header_of(const LayoutDocument& document, const ModelPlan& plan);

}  // namespace beadswim
