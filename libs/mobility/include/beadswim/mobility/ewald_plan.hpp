#pragma once

#include "beadswim/core/vec3.hpp"

// Parameters of an Ewald sum: the division between pairs and mesh, and the mesh spacing, for a given error.

namespace beadswim {

/// Quantities that determine the cost and the error of an Ewald sum.
struct EwaldScene {
  Vec3 lengths = Vec3::Zero();  ///< periodic box, or in open space a box around all beads [length]
  bool is_periodic = true;
  double beads = 0;           ///< number of beads in the box
  double largest_radius = 0;  ///< [length]
  double tolerance = 1e-4;    ///< error of velocities, relative to their root mean square
};

/// Parameters of an Ewald sum.
struct EwaldPlan {
  double xi = 0;       ///< splitting parameter [1/length]
  double cutoff = 0;   ///< distance up to which the near part is summed over pairs [length]
  double spacing = 0;  ///< mesh spacing; in a box an upper bound, so that the mesh fits [length]
  int window = 0;      ///< mesh points under the window of a bead, per axis; even
  double window_shape =
      0;  ///< m; the window is truncated where it has decreased to exp(-m^2/2) of its maximum
};

/// Returns the plan of minimal cost by a model of the work (docs/method/mobility-product.md). In a box the
/// cutoff is at most half the shortest edge, so that only the nearest image of a pair is within it. Throws
/// InputError if the tolerance is not in [1e-12, 1e-2], or if an edge of the box is less than four radii.
EwaldPlan plan_ewald(const EwaldScene& scene);

/// Returns the smallest number of mesh points, at least `min_size`, that has no prime factors except 2, 3, 5
/// and 7. FFTs of such sizes are fast.
int next_fft_size(double min_size);

}  // namespace beadswim
