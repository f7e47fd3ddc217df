#pragma once

#include <vector>

#include "beadswim/coupling/scene_on_lattice.hpp"
#include "beadswim/documents/run_record_document.hpp"

// Warnings of a lattice run. They do not stop the run.

namespace beadswim {

/// Returns the warnings that are known before the run. `roundoff`: relative error of the swimmers' velocity
/// caused by rounding of the populations, from velocity_roundoff().
std::vector<RunWarning> warnings_before(const SceneOnLattice& on_lattice, double roundoff);

/// Returns a warning if the beads were so fast that compressibility affects the results. `mach`: largest Mach
/// number of a bead in the run.
std::vector<RunWarning> warnings_after(double mach);

}  // namespace beadswim
