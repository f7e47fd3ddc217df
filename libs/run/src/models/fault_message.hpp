#pragma once

#include <string>

#include "beadswim/coupling/fault.hpp"
#include "beadswim/coupling/scene_on_lattice.hpp"

namespace beadswim {

/// Returns the message for users about a fault that ended a run: place, fault, likely cause and remedy.
/// `mach_so_far`: largest Mach number of a bead before the fault.
std::string fault_message(const Fault& fault, const SceneOnLattice& on_lattice, double mach_so_far);

}  // namespace beadswim
