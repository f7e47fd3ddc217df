#pragma once

#include <optional>

#include "beadswim/coupling/bead_scheme.hpp"
#include "beadswim/lattice/precision.hpp"

namespace beadswim {

/// How a layout is put on a lattice.
struct LatticeSettings {
  std::optional<double> cells_per_radius;  ///< of the smallest bead; none: the layout's, else 4
  std::optional<double> relaxation_time;   ///< [step]; none: the layout's, else 1
  BeadScheme bead_boundary = BeadScheme::mr;
  bool delay_correction = true;   ///< makes beads heavier by what makes up for late forces (force_delay.hpp)
  bool radius_correction = true;  ///< gives beads the radius for which their drag is that of the layout's
  bool lubrication = true;        ///< adds the resistance of films that the lattice does not resolve
  double friction = 0.5;          ///< Coulomb's coefficient between beads in contact
  Precision precision = Precision::fp64;  ///< floating-point precision of the populations
};

}  // namespace beadswim
