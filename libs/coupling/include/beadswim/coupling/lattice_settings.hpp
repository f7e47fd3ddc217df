#pragma once

#include <optional>

#include "beadswim/coupling/bead_scheme.hpp"
#include "beadswim/lattice/precision.hpp"

namespace beadswim {

/// Settings by which a layout becomes a scene on the lattice.
struct LatticeSettings {
  std::optional<double> cells_per_radius;  ///< of the smallest bead; none: value of the layout, otherwise 4
  std::optional<double> relaxation_time;   ///< tau [step]; none: value of the layout, otherwise 1
  BeadScheme bead_boundary = BeadScheme::mr;
  bool delay_correction = true;   ///< makes beads heavier to compensate the delay of forces (force_delay.hpp)
  bool radius_correction = true;  ///< sets the radius for which the hydrodynamic radius is that of the layout
  bool lubrication = true;        ///< adds the resistance of films that the lattice does not resolve
  double friction = 0.5;          ///< Coulomb's friction coefficient between beads in contact
  Precision precision = Precision::fp64;  ///< floating-point precision of the populations
};

}  // namespace beadswim
