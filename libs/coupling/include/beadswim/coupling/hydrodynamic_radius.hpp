#pragma once

#include "beadswim/coupling/bead_scheme.hpp"

// Hydrodynamic radius of a bead on the lattice: the radius of the sphere that has the same drag in slow flow.
// It was measured for fixed spheres in a cubic array and averaged over positions within a cell. It depends on
// the scheme and on the radius in cells, but not on the relaxation time (docs/verification.md).

namespace beadswim {

/// Returns the hydrodynamic radius minus `radius` [cell]. The result is interpolated linearly between the
/// calibrated radii and constant outside their range.
double excess_radius(BeadScheme scheme, double radius);

/// Returns the radius for which the hydrodynamic radius of a bead is `radius` [cell].
double corrected_radius(BeadScheme scheme, double radius);

}  // namespace beadswim
