#pragma once

#include "beadswim/coupling/bead_scheme.hpp"

// Hydrodynamic radius of a bead on the lattice: the radius of the sphere whose exact drag in slow flow equals
// the drag of the bead. It was measured for fixed spheres in a cubic array and averaged over positions within
// a cell. It depends on the scheme and on the radius in cells, but not on the relaxation time
// (docs/verification.md).

namespace beadswim {

/// Returns the hydrodynamic radius of a bead minus its radius `radius` on the lattice [cell]. The result is
/// interpolated linearly between the radii at which it was measured. Outside the range of these radii it is
/// constant.
double excess_radius(BeadScheme scheme, double radius);

/// Returns the radius on the lattice for which the hydrodynamic radius of a bead equals `radius` [cell].
double corrected_radius(BeadScheme scheme, double radius);

}  // namespace beadswim
