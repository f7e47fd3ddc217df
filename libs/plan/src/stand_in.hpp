#pragma once

#include "beadswim/scene/layout.hpp"
#include "beadswim/swimmers/three_bead_swimmer.hpp"

namespace beadswim {

/// Returns the three-bead swimmer for which errors are estimated instead of a swimmer of another shape. Its
/// beads have the largest radius a of the type, its arms the mean length of the bonds, at least 2.5 a (10 a
/// without bonds), its springs gamma omega/k = 1, its driving the period of the type. The driving forces give
/// its arms the largest relative amplitude of a bond by theory, at least 5 % and at most half the gap between
/// the beads.
ThreeBeadSwimmer stand_in(const SwimmerType& type, const Fluid& fluid);

}  // namespace beadswim
