#pragma once

#include "beadswim/core/communicator.hpp"

namespace beadswim {

/// This process, as the one rank of a run.
const Communicator& one_rank();

}  // namespace beadswim
