#pragma once

#include <optional>

#include "beadswim/core/vec3.hpp"

// Choice of the parameters of an Ewald sum for a given error. The Ewald sum evaluates the velocities of beads
// in Stokes flow from the forces on the beads. It consists of a near part, which is summed over pairs of
// beads, and a far part, which is evaluated on a mesh. Page: docs/method/mobility-product.md.

namespace beadswim {

/// Quantities that determine the cost and the error of an Ewald sum for the velocities of beads in Stokes
/// flow.
struct EwaldScene {
  Vec3 lengths = Vec3::Zero();  ///< edges of the periodic box, or of the box around all beads [length]
  bool is_periodic = true;
  double beads = 0;           ///< number of beads in the box
  double largest_radius = 0;  ///< radius of the largest bead [length]
  int moment_order = 0;       ///< highest moment of the forces (force_moments.hpp)
  double points = 0;          ///< number of points at which the flow is needed; 0: at the beads
  double tolerance = 1e-4;    ///< accepted error of bead velocities, divided by their root mean square
  /// Open space over the wall of a half-space: edges of the box around all beads and their mirror points
  /// [length]. nullopt: no wall.
  std::optional<Vec3> lengths_with_mirror_points{};
  double memory_cutoff = 0;  ///< largest wavenumber of a fluid's memory (fluid_memory.hpp); 0: none
  /// Ewald sum for the root of the mobility of forces in a periodic box (mobility_root.hpp): its parts are
  /// positive, and the near part is summed several times for each evaluation on the mesh.
  bool is_for_root = false;
};

/// Parameters of an Ewald sum, whose near part is summed over pairs of beads and whose far part is evaluated
/// on a mesh.
struct EwaldPlan {
  double cutoff = 0;  ///< distance up to which the near part is summed over pairs [length]
  double shape = 0;   ///< shape of the splitting function: the far part decays to about exp(-shape)
  /// Open space: mesh spacing [length]. Periodic box: upper bound of the mesh spacing; the spacing used
  /// divides each edge of the box.
  double spacing = 0;
  int window = 0;           ///< number of mesh points per axis over which the force on a bead is spread
  double window_shape = 0;  ///< shape of the window, a Kaiser-Bessel function
  /// Over the wall of a half-space: true if the mesh contains the mirror points of the beads. Few beads far
  /// from the wall would need a large mesh that is mostly empty.
  bool has_mirror_points = false;
  bool is_positive = false;  ///< near and far part are positive (mobility_root.hpp)
};

/// Returns the parameters of the Ewald sum with the smallest estimated computing time for the tolerance of
/// the scene (docs/method/mobility-product.md). In a periodic box the cutoff is at most half the shortest
/// edge, so that at most one image of each pair is within the cutoff. For a root there are no parameters in
/// too narrow a box: the cutoff is 0. Throws InputError if the tolerance is not in [1e-12, 1e-2], or if an
/// edge of the periodic box is less than four times the largest radius.
EwaldPlan plan_ewald(const EwaldScene& scene);

/// Returns the parameters of the Ewald sum for the flow at the points of the scene; nullopt if in open space
/// the sum over all pairs of a point and a bead takes less time. Throws InputError as plan_ewald().
std::optional<EwaldPlan> plan_flow(const EwaldScene& scene);

/// Returns the smallest number of mesh points that is at least `min_size` and has no prime factors except 2,
/// 3, 5 and 7. Fast Fourier transforms (FFTs) of such sizes are fast.
int next_fft_size(double min_size);

}  // namespace beadswim
