#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "beadswim/coupling/coupled_system.hpp"

// Data of all cells of a level on rank 0, gathered plane by plane.

namespace beadswim {

/// Gathers one plane of a level on rank 0: `components` doubles per cell, in the order component (slowest),
/// y, x (fastest). `z` counts from the first plane of the level. Each rank calls value(component, cell) for
/// the cells of its block; cells under a finer level get 0. Returns an empty vector on other ranks.
/// Collective.
std::vector<double> gather_plane(const Level& level, const Communicator& communicator, int z, int components,
                                 const std::function<double(int component, std::ptrdiff_t cell)>& value);

/// Returns the SHA-256 hash of the populations of all levels, in the order of gather_plane(), and of the
/// states of all beads, in the order of the ids of their swimmers. The hash does not depend on the number of
/// ranks. Returns an empty string on ranks other than 0. Collective.
std::string state_sha256(const CoupledSystem& system, const Communicator& communicator);

}  // namespace beadswim
