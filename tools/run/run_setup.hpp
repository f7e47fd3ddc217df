#pragma once

#include <memory>

#include "beadswim/documents/layout_document.hpp"
#include "beadswim/io/h5md.hpp"
#include "command_line/request.hpp"
#include "models/model.hpp"

namespace beadswim {

/// Returns the description of the run with the requested model. Throws InputError on all ranks if the model
/// cannot treat the layout. Collective.
std::unique_ptr<ModelPlan> plan_for(const LayoutDocument& document, const Request& request,
                                    const Communicator& communicator);

/// Returns the constant data of the trajectory file: box, beads, layout and program version.
TrajectoryHeader header_of(const LayoutDocument& document, const ModelPlan& plan);

}  // namespace beadswim
