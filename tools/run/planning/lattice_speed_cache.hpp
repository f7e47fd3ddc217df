#pragma once

#include <string>

#include "beadswim/core/communicator.hpp"
#include "beadswim/io/json.hpp"
#include "beadswim/plan/lattice_speed.hpp"

namespace beadswim {

/// Returns the speed in the cache of an earlier call by the same version on the same processor and number of
/// ranks (speed_cache()); otherwise measures it, which takes some seconds and is said on standard error.
/// Collective.
LatticeSpeed speed_of_this_machine(const Communicator& communicator);

Json lattice_speed_to_json(const LatticeSpeed& speed);

/// Throws an exception if it is not what lattice_speed_to_json gives.
LatticeSpeed lattice_speed_from_json(const Json& json);

/// The file that keeps it: in $XDG_CACHE_HOME/beadswim, else ~/.cache/beadswim; empty where there is neither.
std::string speed_cache(int ranks);

}  // namespace beadswim
