#pragma once

#include "beadswim/coupling/lattice_scales.hpp"
#include "beadswim/coupling/scene.hpp"
#include "beadswim/layout/layout.hpp"
#include "options.hpp"

namespace beadswim {

/// A layout's scene on the lattice that the options, the layout's hint or the defaults ask for.
struct SceneOnLattice {
  LatticeChoice lattice;
  double cells_per_radius = 0;
  double period = 0;  ///< base period: the first type's [time]
  CoupledScene scene;
};

/// Throws InputError if the layout cannot be run on a lattice: no box, edges that are not whole numbers of
/// cells, swimmers of different periods.
SceneOnLattice put_on_lattice(const Layout& layout, const RunOptions& options);

}  // namespace beadswim
