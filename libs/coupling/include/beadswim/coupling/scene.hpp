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

/// No bead's surface may move faster: it must not cross half a cell in a step (the paper's rule) [cell/step].
constexpr double speed_limit = 0.5;

/// A scene in lattice units: cell = step = mean fluid density = 1. Cell (i,j,k) is the cube from (i,j,k) to
/// (i+1,j+1,k+1).
struct CoupledScene : Swarm {
  Index3 cells = Index3::Zero();
  std::array<Boundary, 3> boundary{};
  double relaxation_time = 1;
  Precision precision = Precision::fp64;  ///< of the populations
  BeadScheme bead_boundary = BeadScheme::staircase;
  bool corrects_radii = false;  ///< gives beads the radii for which their hydrodynamic radii are the types'
  bool lubrication = true;  ///< adds the resistance of films between beads that the lattice does not resolve
  double friction = 0;      ///< Coulomb's coefficient, of beads in contact

  /// Radius of a bead of a type as the fluid meets it [cell].
  double radius_on_lattice(const Bead& bead) const {
    return corrects_radii ? corrected_radius(bead_boundary, bead.radius) : bead.radius;
  }
};

}  // namespace beadswim
