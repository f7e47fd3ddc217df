#pragma once

#include <array>
#include <vector>

#include "beadswim/core/box.hpp"
#include "beadswim/core/vec3.hpp"
#include "beadswim/coupling/bead_scheme.hpp"
#include "beadswim/coupling/hydrodynamic_radius.hpp"
#include "beadswim/lattice/precision.hpp"
#include "beadswim/scene/placed_swimmers.hpp"

namespace beadswim {

/// Largest permitted speed of the surface of a bead: half a cell per step (stop rule of the paper)
/// [cell/step].
constexpr double speed_limit = 0.5;

/// A scene in lattice units: cell = step = mean fluid density = 1. Cell (i,j,k) is the cube from (i,j,k) to
/// (i+1,j+1,k+1).
struct CoupledScene : Swarm {
  Index3 cells = Index3::Zero();
  std::array<Boundary, 3> boundary{};
  double relaxation_time = 1;             ///< tau [step]
  Precision precision = Precision::fp64;  ///< floating-point precision of the populations
  BeadScheme bead_boundary = BeadScheme::staircase;
  bool corrects_radii = false;  ///< sets radii for which the hydrodynamic radii are those of the types
  bool lubrication = true;  ///< adds the resistance of films between beads that the lattice does not resolve
  double friction = 0;      ///< Coulomb's friction coefficient between beads in contact

  /// Returns the radius of a bead for the fluid [cell].
  double radius_on_lattice(const Bead& bead) const {
    return corrects_radii ? corrected_radius(bead_boundary, bead.radius) : bead.radius;
  }
};

}  // namespace beadswim
