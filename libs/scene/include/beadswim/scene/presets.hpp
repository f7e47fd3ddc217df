#pragma once

#include "beadswim/scene/layout.hpp"
#include "beadswim/scene/swarm.hpp"

// Scenes of the paper, and rules that derive parameters of a scene from others.

namespace beadswim {

/// Returns the single swimmer of the paper's section 4 in a free-slip box of 1200 x 800 x 800, in lattice
/// units: radii 4, arms 20, k = 0.0347, no dashpots, A = B = 0.2, alpha = pi/2, T = 4800, bead and fluid
/// density 1, nu = 1/3.
Layout paper_single();

/// Returns fluid and type of the swarms of the paper's sections 5 and 6, without box and swimmers, in lattice
/// units: radii 6, arms 32, A = B = 2, alpha = pi/2, T = 2000, densities 1, nu = 1/3. The paper does not
/// state the stiffness. k = 0.2 without dashpots keeps the beads apart; with 0.0347, the value of the single
/// swimmer, they collide.
Layout paper_swarm();

/// Returns blocks of 1 x 3 x 3 swimmers with all distances 32. A block then measures 96 x 96 x 96.
SwarmPlan paper_uniform_plan();

/// Returns blocks of 1 x 3 x 3 swimmers with C = 37, D_x = 56, D_y = D_z = 46, as in simulations (c) to (g).
/// A block then measures 120 x 120 x 120.
SwarmPlan paper_defect_plan();

/// Returns the angular stiffness that keeps a swimmer nearly straight: K_A = 10 k l^2, with the mean k and l
/// of its arms. Displacing an end bead sideways then requires ten times the force of displacing it along its
/// arm.
double straightening_stiffness(const SwimmerType& type);

/// Returns the resolution of the paper, where the cell and the time step are the units of length and time.
/// The number of cells per radius is then the smallest radius, and nu = (tau - 1/2)/3.
Resolution unit_resolution(const SwimmerType& type, const Fluid& fluid);

/// Returns the position of bead 2 [length] for a swimmer in the middle of the box. The middle of the swimmer
/// is the midpoint between the outer ends of beads 1 and 3. Returns the origin in open space.
Vec3 centred_position(const SwimmerType& type, const Vec3& axis, const std::optional<Box>& domain);

}  // namespace beadswim
