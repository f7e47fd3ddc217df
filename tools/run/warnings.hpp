#pragma once

#include "scene_on_lattice.hpp"

// What a run says on standard error and does all the same. Of one rank.

namespace beadswim {

/// What may go wrong, known before it starts.
/// roundoff: velocity_roundoff().
void warn(const SceneOnLattice& on_lattice, double roundoff);

/// A lattice fluid is nearly incompressible only while it is slow. mach: the largest of the run.
void warn_if_fast(double mach);

}  // namespace beadswim
