#pragma once

#include <string>

#include "beadswim/coupling/lattice_settings.hpp"
#include "beadswim/coupling/scene.hpp"
#include "beadswim/scene/layout.hpp"
#include "beadswim/scene/unit_scales.hpp"

namespace beadswim {

/// Smallest density of a bead at which the explicit coupling of beads and fluid is stable in all tested cases
/// [density of the fluid].
constexpr double min_stable_density = 0.65;

/// Smallest relaxation time tau [step] at which the schemes with links (all except psm) are stable. At
/// smaller values, viscosity hardly damps flow on the scale of a cell.
constexpr double min_stable_relaxation_time = 0.52;

/// Mach number above which compressibility of the fluid affects the results.
constexpr double max_incompressible_mach = 0.3;

/// Discretisation of a scene.
struct LatticeChoice {
  UnitScales scales;           ///< cell, step and density of the fluid
  double relaxation_time = 1;  ///< tau, adapted to the time step [step]
  long steps_per_period = 0;
};

/// Returns cell, step and relaxation time for a fluid of kinematic viscosity nu:
/// - cell = radius/cells_per_radius
/// - step = nu_lu cell^2/nu with nu_lu = (tau - 1/2)/3, rounded such that `period` is an integer number of
///   steps, which is a multiple of `multiple`
/// - relaxation time: tau, adapted to the rounded step
LatticeChoice choose_lattice(double radius, const Resolution& resolution, const Fluid& fluid, double period,
                             long multiple = 1);

/// The scene of a layout on the lattice, and the lattice itself. The resolution comes from the settings,
/// otherwise from the layout, otherwise from the defaults.
struct SceneOnLattice {
  LatticeChoice lattice;
  Resolution resolution;    ///< as requested; `lattice` has the relaxation time adapted to the period
  double period = 0;        ///< base period: of all swimmers, otherwise of the first swimmer's type [time]
  double smallest_gap = 0;  ///< smallest gap at the start: bead to bead, image or wall [cell]
  /// True if springs vibrate too fast for the time step and got additional damping
  /// (with_resolved_vibrations).
  bool damps_springs = false;
  /// Ratio of the stiffness on the lattice to that in the layout, for each type and angular spring. It is
  /// less than 1 if bending vibrates too fast for the time step (with_resolved_vibrations).
  std::vector<std::vector<double>> softening;
  CoupledScene scene;

  double angular_softening() const;  ///< smallest of all `softening`; 1 without angular springs

  /// Returns the smallest density of a bead on the lattice [density of the fluid].
  double density_on_lattice() const;

  /// Returns the radius with which the smallest bead acts on the fluid [cell].
  double radius_on_lattice() const { return scene.radius_on_lattice(resolution.cells_per_radius); }
};

/// Converts a layout to a scene on the lattice. Throws InputError, with `source` as the name of the layout,
/// in these cases:
/// - The layout has no box, or an edge of the box is not an integer number of cells.
/// - The radius of a bead is smaller than a cell, or a bead is too near to a wall.
/// - The time step is too long for the shortest driving period.
/// - The scheme has links and the relaxation time is below min_stable_relaxation_time.
/// - The scheme is mr and the relaxation time is near the value at which this scheme is undefined.
SceneOnLattice put_on_lattice(const Layout& layout, const LatticeSettings& settings,
                              const std::string& source);

}  // namespace beadswim
