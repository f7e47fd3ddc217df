#pragma once

#include <string>
#include <vector>

#include "beadswim/coupling/scene_on_lattice.hpp"

// What a lattice run says on standard error and does all the same, a line each.

namespace beadswim {

/// What may go wrong, known before it starts. roundoff: velocity_roundoff().
std::vector<std::string> warnings_before(const SceneOnLattice& on_lattice, double roundoff);

/// A lattice fluid is nearly incompressible only while it is slow. mach: the largest of the run.
std::vector<std::string> warnings_after(double mach);

}  // namespace beadswim
