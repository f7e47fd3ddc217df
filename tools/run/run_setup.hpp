#pragma once

#include <memory>

#include "beadswim/documents/layout_document.hpp"
#include "beadswim/io/h5md.hpp"
#include "command_line/request.hpp"
#include "models/model.hpp"

namespace beadswim {

/// How the layout is run. Throws InputError alike on all ranks. Collective.
std::unique_ptr<ModelPlan> plan_for(const LayoutDocument& document, const Request& request,
                                    const Communicator& communicator);

/// What does not change in the run's trajectory.
TrajectoryHeader header_of(const LayoutDocument& document, const ModelPlan& plan);

}  // namespace beadswim
