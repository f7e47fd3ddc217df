#pragma once

#include <functional>
#include <string>

#include "beadswim/core/communicator.hpp"
#include "beadswim/io/json.hpp"
#include "beadswim/plan/lattice_speed.hpp"

namespace beadswim {

/// Returns the time of lattice steps on this machine at present. If the same version of the program has
/// already measured it on the same processor with the same number of ranks, reads the time from the cache
/// file speed_cache_path() and corrects it by short measurements. Otherwise measures the time, which takes
/// some seconds and which `message` announces on rank 0, and writes the cache file. Collective.
LatticeSpeed speed_of_this_machine(const std::function<void(const std::string&)>& message,
                                   const Communicator& communicator);

Json lattice_speed_to_json(const LatticeSpeed& speed);

/// Converts JSON that lattice_speed_to_json() has made to a LatticeSpeed. Throws an exception derived from
/// std::exception if `json` has another form.
LatticeSpeed lattice_speed_from_json(const Json& json);

/// Returns the path of the cache file for this number of ranks. The folder is $XDG_CACHE_HOME/beadswim or,
/// without this variable, $HOME/.cache/beadswim. The path is empty if neither variable is set.
std::string speed_cache_path(int ranks);

}  // namespace beadswim
