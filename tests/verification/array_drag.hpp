#pragma once

#include "beadswim/coupling/bead_scheme.hpp"
#include "places.hpp"

namespace beadswim::verification {

/// Returns the drag coefficient K = F/(6 pi eta R U) of a fixed array of spheres. `offset`: position of the
/// sphere relative to the middle of the box [cell].
double array_drag(const CubicArray& array, const Vec3& offset, double relaxation_time, BeadScheme scheme);

}  // namespace beadswim::verification
