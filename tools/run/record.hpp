#pragma once

#include "beadswim/documents/layout_document.hpp"
#include "run_loop.hpp"

namespace beadswim {

/// The run record; whole on rank 0. Collective.
RunRecord make_record(const RunParts& parts, const LayoutDocument& layout, const RunOutcome& outcome);

}  // namespace beadswim
