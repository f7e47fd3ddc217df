#pragma once

#include "beadswim/scene/layout.hpp"
#include "beadswim/scene/swarm.hpp"
#include "beadswim/swimmers/three_bead_swimmer.hpp"

// Scenes of the paper (Pickl et al. 2017), and rules that derive parameters of a scene from others.

namespace beadswim {

/// Returns the single swimmer of the paper's section 4 in a free-slip box of 1200 x 800 x 800, in lattice
/// units: bead radii 4, rest lengths 20, stiffness k = 0.0347, no dashpots, driving amplitudes A = B = 0.2,
/// driving phase alpha = pi/2, period T = 4800, density 1 of beads and fluid, kinematic viscosity nu = 1/3.
Layout paper_single();

/// Returns fluid and type of the swarms of the paper's sections 5 and 6, without box and swimmers, in lattice
/// units: bead radii 6, rest lengths 32, A = B = 2, alpha = pi/2, T = 2000, nu = 1/3, density 1 of beads and
/// fluid. The paper does not state the stiffness of these swimmers. With k = 0.2 and without dashpots, the
/// beads stay apart. With k = 0.0347, the stiffness of the single swimmer, the beads collide.
Layout paper_swarm();

/// Returns blocks of 1 x 3 x 3 swimmers. All distances between bead centres of neighbouring swimmers are 32
/// (in lattice units), in the same block (C) and in different blocks (D). A block then measures 96 x 96 x 96.
SwarmPlan paper_uniform_plan();

/// Returns blocks of 1 x 3 x 3 swimmers as in simulations (c) to (g) of the paper. The distance between bead
/// centres of neighbouring swimmers is C = 37 in the same block, and D_x = 56, D_y = D_z = 46 in different
/// blocks (in lattice units). A block then measures 120 x 120 x 120.
SwarmPlan paper_defect_plan();

/// Returns the angular stiffness that keeps a swimmer nearly straight: K_A = 10 k l^2, where k is the mean
/// stiffness and l the mean rest length of its arms. A sideways displacement of an end bead then requires ten
/// times the force of an equal displacement along its arm.
double straightening_stiffness(const ThreeBeadSwimmer& swimmer);
double straightening_stiffness(double stiffness, double arm);

/// Returns the resolution at which the cell and the time step are the units of length and time, as in the
/// paper. The number of cells per radius is then the smallest bead radius. The relaxation time tau follows
/// from the kinematic viscosity nu = (tau - 1/2)/3.
Resolution unit_resolution(const SwimmerType& type, const Fluid& fluid);

/// Returns the shift [length] of a swimmer in the middle of a box: 0.15 and 0.05 times the smallest radius
/// along the two coordinate axes across the swimmer, but 0 along axes that are not periodic. Errors by the
/// positions of beads within cells are largest for beads on planes of the lattice. With this shift, beads are
/// on none of these planes at 2 to 8 cells per radius (docs/resolution.md).
Vec3 shift_off_lattice_planes(const SwimmerType& type, const Vec3& axis, const Box& box);

/// Returns the position [length] of a swimmer in the middle of the box, with the shift off lattice planes.
/// The middle of the swimmer is that of the smallest cuboid along the axes of its frame that contains its
/// beads: the midpoint between the outer ends of beads 1 and 3 of a three-bead swimmer. Returns the origin in
/// open space.
Vec3 centred_position(const SwimmerType& type, const Eigen::Matrix3d& orientation,
                      const std::optional<Box>& domain);

}  // namespace beadswim
