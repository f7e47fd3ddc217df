#pragma once

#include "beadswim/core/vec3.hpp"

// Parameters of an Ewald sum for a given error. The sum has a near part, which is summed over pairs of beads,
// and a far part, which is evaluated on a mesh (ewald_split.hpp).

namespace beadswim {

/// Quantities that determine the cost and the error of an Ewald sum.
struct EwaldScene {
  Vec3 lengths = Vec3::Zero();  ///< edges of the periodic box; open space: box around all beads [length]
  bool is_periodic = true;
  double beads = 0;           ///< number of beads in the box
  double largest_radius = 0;  ///< [length]
  double tolerance = 1e-4;    ///< error of the velocities, divided by their root mean square
};

/// Parameters of an Ewald sum.
struct EwaldPlan {
  double xi = 0;      ///< splitting parameter of ewald_split.hpp [1/length]
  double cutoff = 0;  ///< distance up to which the near part is summed over pairs [length]
  /// Mesh spacing [length]. In a periodic box it is an upper bound: the spacing used divides the edge.
  double spacing = 0;
  /// Number of mesh points per axis that receive the Gaussian of a bead (its window). Even.
  int window = 0;
  /// m: the Gaussian is truncated where it has decreased to exp(-m^2/2) of its maximum.
  double window_shape = 0;
};

/// Returns the plan with the smallest estimated computing time (docs/method/mobility-product.md). In a
/// periodic box the cutoff is at most half the shortest edge, so that at most one image of each pair is
/// within the cutoff. Throws InputError if the tolerance is not in [1e-12, 1e-2], or if an edge of the
/// periodic box is less than four times the largest radius.
EwaldPlan plan_ewald(const EwaldScene& scene);

/// Returns the smallest number of mesh points that is at least `min_size` and has no prime factors except 2,
/// 3, 5 and 7. Fast Fourier transforms (FFTs) of such sizes are fast.
int next_fft_size(double min_size);

}  // namespace beadswim
