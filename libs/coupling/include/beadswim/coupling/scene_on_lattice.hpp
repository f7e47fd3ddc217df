#pragma once

#include <string>

#include "beadswim/coupling/lattice_scales.hpp"
#include "beadswim/coupling/lattice_settings.hpp"
#include "beadswim/coupling/scene.hpp"
#include "beadswim/scene/layout.hpp"

namespace beadswim {

/// Beads of less density on the lattice may be too light for the explicit coupling [density of the fluid].
constexpr double light_bead = 0.65;

/// Below this relaxation time links into beads become unstable, and viscosity hardly damps what cells do not
/// resolve.
constexpr double least_viscous = 0.52;

/// From this Mach number on the fluid's compressibility shows.
constexpr double fast_bead = 0.3;

/// A layout's scene on the lattice that the settings, the layout's hint or the defaults ask for.
struct SceneOnLattice {
  LatticeChoice lattice;
  Resolution resolution;    ///< as requested: relaxation time before the period was fitted to whole steps
  double period = 0;        ///< base period: the swimmers', else that of the first one's type [time]
  double smallest_gap = 0;  ///< at the start, between beads, images and walls [cell]
  bool corrects_delay = false;
  bool damps_springs = false;  ///< some, which vibrate faster than steps resolve (with_steady_vibrations)
  double angular_softening =
      1;  ///< stiffness of the angular spring most softened over the layout's (likewise)
  CoupledScene scene;

  /// Least density with which a bead moves [density of the fluid].
  double density_on_lattice() const;

  /// With which the fluid meets the smallest bead [cell].
  double radius_on_lattice() const {
    const double radius = resolution.cells_per_radius;
    return scene.corrects_radii ? corrected_radius(scene.bead_boundary, radius) : radius;
  }
};

/// Throws InputError, `source` naming the layout, if the layout cannot be run on a lattice: no box, edges
/// that are not whole numbers of cells, beads at walls, steps too long beside the shortest period, too little
/// viscosity for links.
SceneOnLattice put_on_lattice(const Layout& layout, const LatticeSettings& settings,
                              const std::string& source);

}  // namespace beadswim
