#pragma once

#include <array>
#include <vector>

#include "beadswim/core/box.hpp"
#include "beadswim/core/vec3.hpp"
#include "beadswim/coupling/bead_corrections.hpp"
#include "beadswim/lattice/block.hpp"
#include "beadswim/lattice/precision.hpp"
#include "beadswim/scene/placed_swimmers.hpp"

namespace beadswim {

/// Largest permitted speed of the surface of a bead [cell/step]. This is the stop rule of Pickl et al. 2017.
constexpr double speed_limit = 0.5;

/// A scene in lattice units: cell = step = mean fluid density = 1. Cell (i,j,k) is the cube from (i,j,k) to
/// (i+1,j+1,k+1).
struct CoupledScene : Swarm {
  Index3 cells = Index3::Zero();  ///< cells of the box, if all cells are as small as those at the beads
  std::array<Boundary, 3> boundary{};
  std::array<WallVelocities, 3> walls{};
  Vec3 body_force = Vec3::Zero();  ///< momentum that each cell gains in a step
  /// Cells of each level (levels.hpp) in coordinates of its own cells, coarsest first. The first level fills
  /// the box, the last contains all beads. Empty: one level.
  std::vector<Block> levels;
  double relaxation_time = 1;             ///< tau [step]
  Precision precision = Precision::fp64;  ///< floating-point precision of the populations
  BeadScheme bead_boundary = BeadScheme::staircase;
  bool corrects_delay = false;  ///< the densities of the types include delay_density()
  bool corrects_radii = false;  ///< adapts radii so that hydrodynamic radii equal the radii of the types
  bool lubrication = true;  ///< adds the resistance of films between beads that the lattice does not resolve
  double friction = 0;      ///< Coulomb's friction coefficient between beads in contact

  /// Returns `levels` or, if it is empty, the one level that fills the box.
  std::vector<Block> all_levels() const {
    return levels.empty() ? std::vector<Block>{{.offset = Index3::Zero(), .size = cells}} : levels;
  }

  /// Returns the radius with which a bead of this radius acts on the fluid, corrected if corrects_radii is
  /// true [cell].
  double radius_on_lattice(double radius) const {
    return corrects_radii ? corrected_radius(bead_boundary, radius) : radius;
  }
};

}  // namespace beadswim
