#pragma once

#include <memory>

#include "beadswim/documents/layout_document.hpp"
#include "beadswim/io/h5md.hpp"
#include "command_line/request.hpp"
#include "models/model.hpp"

namespace beadswim {

/// Returns the plan of the run with the requested model. Throws InputError on all ranks. Collective.
std::unique_ptr<ModelPlan> plan_for(const LayoutDocument& document, const Request& request,
                                    const Communicator& communicator);

/// Returns the constant data of the trajectory: box, beads, layout and version.
TrajectoryHeader header_of(const LayoutDocument& document, const ModelPlan& plan);

}  // namespace beadswim
