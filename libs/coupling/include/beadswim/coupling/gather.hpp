#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "beadswim/coupling/coupled_system.hpp"

// The whole lattice, plane by plane, on rank 0.

namespace beadswim {

/// Collects one plane z of the lattice on rank 0: `components` doubles a cell, components slowest, then y, x.
/// value(component, cell) is asked for the block's own cells. Empty on other ranks. Collective.
std::vector<double> gather_plane(const CoupledSystem& system, const Communicator& communicator, int z,
                                 int components,
                                 const std::function<double(int component, std::ptrdiff_t cell)>& value);

/// Hash of the populations in global order and of all swimmers' motion in order of their id: the same for any
/// number of ranks. On rank 0; empty elsewhere. Collective.
std::string state_sha256(const CoupledSystem& system, const Communicator& communicator);

}  // namespace beadswim
