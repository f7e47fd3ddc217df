#pragma once

#include "beadswim/coupling/bead_scheme.hpp"

// The radius that a bead on the lattice seems to have, by its drag in slow flow: measured for fixed spheres
// in a cubic array, as a mean over places within a cell. It depends on the scheme and on the radius in cells,
// not on the relaxation time (docs/verification.md).

namespace beadswim {

/// Hydrodynamic radius less the radius that the bead was given [cell]. Between the radii of the calibration
/// by linear interpolation; below the smallest and above the largest of them as there.
double excess_radius(BeadScheme scheme, double radius);

/// The radius to give a bead so that its hydrodynamic radius is `radius` [cell].
double corrected_radius(BeadScheme scheme, double radius);

}  // namespace beadswim
