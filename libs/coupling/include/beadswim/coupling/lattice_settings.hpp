#pragma once

#include <optional>

#include "beadswim/coupling/bead_scheme.hpp"
#include "beadswim/lattice/precision.hpp"

namespace beadswim {

/// Largest number of levels of cells below the coarsest.
constexpr int max_finer_levels = 5;

/// Settings for the conversion of a layout to a scene on the lattice.
struct LatticeSettings {
  /// Cells per radius of the smallest bead. If not set: the value in the layout, or 4 if the layout has none.
  std::optional<double> cells_per_radius;
  /// Relaxation time tau [step]. If not set: the value in the layout, or 1 if the layout has none.
  std::optional<double> relaxation_time;
  BeadScheme bead_boundary = BeadScheme::mr;
  bool delay_correction = true;   ///< makes beads heavier to compensate the delay of forces
  bool radius_correction = true;  ///< adapts radii so that hydrodynamic radii equal the radii in the layout
  bool lubrication = true;  ///< adds the resistance of thin films between beads that cells do not resolve
  double friction = 0.5;    ///< Coulomb's friction coefficient between beads in contact
  Precision precision = Precision::fp64;  ///< floating-point precision of the populations
  /// Number of levels of cells below the coarsest (levels.hpp). If not set: the cheapest number for the
  /// scene.
  std::optional<int> refinement = 0;
};

}  // namespace beadswim
