#pragma once

#include "beadswim/core/communicator.hpp"

namespace beadswim {

/// Returns a communicator that contains this process only.
const Communicator& one_rank();

}  // namespace beadswim
