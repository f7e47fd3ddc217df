#pragma once

#include "beadswim/scene/layout.hpp"
#include "beadswim/scene/swarm.hpp"

// Scenes of the paper, and the rules by which a scene is completed from fewer numbers.

namespace beadswim {

/// One swimmer of the paper's section 4: radii 4, arms 20, k = 0.0347, no dashpots, A = B = 0.2, alpha =
/// pi/2, T = 4800, bead and fluid density 1, nu = 1/3, in a free-slip box 1200 x 800 x 800. Lattice units.
Layout paper_single();

/// What the swarms of the paper's sections 5 and 6 are made of, without box and swimmers: radii 6, arms 32,
/// A = B = 2, alpha = pi/2, T = 2000, densities 1, nu = 1/3, lattice units. The paper gives no stiffness; k =
/// 0.2 without dashpots keeps the beads apart (with its single swimmer's 0.0347 they collide).
Layout paper_swarm();

/// Blocks of 1 x 3 x 3 swimmers; all gaps 32, so that a block is 96 x 96 x 96.
SwarmPlan paper_uniform_plan();

/// The same with C = 37, D_x = 56, D_y = D_z = 46 (simulations (c) to (g)): 120 x 120 x 120.
SwarmPlan paper_defect_plan();

/// The stiffness that keeps a swimmer straight: K_A = 10 k l^2 with the mean k and l of its arms. Moving an
/// end bead sideways then costs ten times the force of moving it along its arm.
double straightening_stiffness(const SwimmerType& type);

/// The paper's own resolution: cells and time steps are the units of length and time. Then the smallest
/// radius is the number of cells per radius, and nu = (tau - 1/2)/3.
Resolution unit_resolution(const SwimmerType& type, const Fluid& fluid);

/// The place of bead 2 that puts the middle of a swimmer, from the far side of bead 1 to that of bead 3, in
/// the middle of the box; the origin in unbounded fluid.
Vec3 centred_position(const SwimmerType& type, const Vec3& axis, const std::optional<Box>& domain);

}  // namespace beadswim
