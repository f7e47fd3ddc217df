#pragma once

#include "beadswim/coupling/bead_scheme.hpp"
#include "places.hpp"

namespace beadswim::verification {

/// Drag coefficient K = F/(6 pi eta R U) of a fixed array, its sphere `offset` from the middle of the box
/// [cell].
double array_drag(const CubicArray& array, const Vec3& offset, double relaxation_time, BeadScheme scheme);

}  // namespace beadswim::verification
