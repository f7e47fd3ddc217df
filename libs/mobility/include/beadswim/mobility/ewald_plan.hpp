#pragma once

#include "beadswim/core/vec3.hpp"

// How a sum over beads is shared between pairs and a mesh, and how fine the mesh is, for a stated error.

namespace beadswim {

/// Sizes that decide cost and error of an Ewald sum.
struct EwaldScene {
  Vec3 lengths = Vec3::Zero();  ///< of the periodic box, or of what holds all beads in open space [length]
  bool is_periodic = true;
  double beads = 0;           ///< in the box
  double typical_radius = 0;  ///< the largest [length]
  double tolerance = 1e-4;    ///< of velocities, relative to their root mean square
};

struct EwaldPlan {
  double xi = 0;            ///< splitting [1/length]
  double cut_off = 0;       ///< of pairs' near part [length]
  double spacing = 0;       ///< of the mesh; in a box at most this, so that points divide its edges [length]
  int window = 0;           ///< points of the mesh that a bead meets along an axis, even
  double window_shape = 0;  ///< m: windows are cut where they are exp(-m^2/2) of their middle
};

/// The plan that costs least, by a model of the work (docs/method/mobility-product.md). In a box the cut-off
/// is half its shortest edge at most, so that pairs meet once. Throws InputError if the tolerance is not in
/// [1e-12, 1e-2], or an edge of the box less than four radii.
EwaldPlan plan_ewald(const EwaldScene& scene);

/// A number of points at least this that FFTs like: of factors 2, 3, 5 and 7.
int good_mesh_size(double at_least);

}  // namespace beadswim
