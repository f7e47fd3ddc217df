#pragma once

#include <string>

#include "beadswim/coupling/fault.hpp"
#include "beadswim/coupling/scene_on_lattice.hpp"

namespace beadswim {

/// Where, what, the likely cause and what to change, for people. mach_so_far: of the fastest bead that was
/// within the limit.
std::string fault_message(const Fault& fault, const SceneOnLattice& on_lattice, double mach_so_far);

}  // namespace beadswim
