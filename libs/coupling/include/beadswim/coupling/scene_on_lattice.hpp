#pragma once

#include <string>

#include "beadswim/coupling/lattice_scales.hpp"
#include "beadswim/coupling/lattice_settings.hpp"
#include "beadswim/coupling/scene.hpp"
#include "beadswim/scene/layout.hpp"

namespace beadswim {

/// Density below which a bead may be too light for the explicit coupling [density of the fluid].
constexpr double min_stable_density = 0.65;

/// Relaxation time below which links become unstable and viscosity hardly damps flow on the scale of a cell
/// [step].
constexpr double min_stable_relaxation_time = 0.52;

/// Mach number above which compressibility of the fluid affects the results.
constexpr double max_incompressible_mach = 0.3;

/// The scene of a layout on the lattice, and the lattice that follows from the settings, the resolution in
/// the layout or the defaults.
struct SceneOnLattice {
  LatticeChoice lattice;
  Resolution resolution;    ///< as requested, that is before the relaxation time was adapted to the period
  double period = 0;        ///< base period: common to all swimmers, otherwise that of the first type [time]
  double smallest_gap = 0;  ///< at the start, between beads, images and walls [cell]
  bool corrects_delay = false;
  bool damps_springs = false;  ///< true if springs vibrate too fast for the step (with_resolved_vibrations)
  /// Smallest ratio of an angular stiffness to that of the layout (with_resolved_vibrations).
  double angular_softening = 1;
  CoupledScene scene;

  /// Returns the smallest density of a bead on the lattice [density of the fluid].
  double density_on_lattice() const;

  /// Returns the radius of the smallest bead for the fluid [cell].
  double radius_on_lattice() const {
    const double radius = resolution.cells_per_radius;
    return scene.corrects_radii ? corrected_radius(scene.bead_boundary, radius) : radius;
  }
};

/// Converts a layout to a scene on the lattice. Throws InputError, with `source` as the name of the layout,
/// in these cases: the layout has no box, an edge of the box is not an integer number of cells, a bead is too
/// near to a wall or smaller than a cell, the step is too long for the shortest period, or the relaxation
/// time is unsuitable for the links.
SceneOnLattice put_on_lattice(const Layout& layout, const LatticeSettings& settings,
                              const std::string& source);

}  // namespace beadswim
