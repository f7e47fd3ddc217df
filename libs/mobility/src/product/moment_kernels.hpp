#pragma once

#include "beadswim/core/kernel.hpp"
#include "mobility_kernels.hpp"
#include "wall_reflection.hpp"

// Kernels of a mobility product with force moments (force_moments.hpp), compiled once per instruction set, as
// those of mobility_kernels.hpp.

namespace beadswim {

/// Pairs of one sphere with up to 8 other spheres, one in each lane. The vector r of a pair is the position
/// of the one sphere minus the position of the other. Unused lanes contain a copy of another pair and sources
/// of zero.
struct MomentPairs {
  double r[3][lanes];
  /// ((1/r) d/dr)^n of chi, of its Laplacian and of its second Laplacian, divided by 8 pi eta. chi[0] is not
  /// used.
  double chi[7][lanes], laplacian[7][lanes], bilaplacian[5][lanes];
  double source[30][lanes];  ///< derivatives of point forces of the other spheres
  double size[3][lanes];     ///< c_l a^2 of the other spheres
  double flow[30][lanes];    ///< flow of the one sphere at the other spheres
};

/// Up to 8 spheres, one in each lane, whose flow at a point is needed. The vector r is the point minus the
/// position of the sphere. Unused lanes contain a copy of another sphere and sources of zero.
struct PointSources {
  double r[3][lanes];
  double chi[9][lanes], laplacian[9][lanes], bilaplacian[7][lanes];  ///< as of MomentPairs
  bool has_bilaplacian;                                              ///< false: it is 0
  double source[30][lanes];
  double size[3][lanes];
};

/// Sum of the flows of many spheres at a mirror point, with one part of the sum in each lane.
struct MirrorFlowParts {
  double velocity[3][derivative_count(2)][lanes]{};
  double across[MirrorFlow::max_count][lanes]{}, pressure[MirrorFlow::max_count][lanes]{};
};

/// The one sphere of MomentPairs.
struct OneSphere {
  const double* source;
  double size[3];
  double* flow;  ///< the flow of the other spheres is added to it
};

/// A mesh of three components that beads spread to or gather from: component c at values[c].
using MeshValues = double* const*;
using ConstMeshValues = const double* const*;

struct MomentKernels {
  /// Evaluates the flows of all pairs in both directions.
  void (*moment_pairs)(int order, const OneSphere&, MomentPairs&);
  /// Adds the flow of the sources at the mirror point of a sphere. `axis`: of the wall's normal.
  void (*mirror_flow)(int order, int axis, const PointSources&, MirrorFlowParts&);
  /// Adds the derivatives of the mesh values at mirror points, divided by the volume of a mesh cell. `from`:
  /// meshes of the three components of the velocity and of the pressure.
  void (*gather_mirror_flows)(int order, int axis, const WindowMesh&, const WindowBeads& points,
                              const double* const* from, MirrorFlow* flows);
  /// Adds the derivatives of the windows of the beads, multiplied by `sources`, to the three meshes.
  /// `sources`: 3 * derivative_count(order) numbers per bead.
  void (*spread_moments)(int order, const WindowMesh&, const WindowBeads&, const double* sources,
                         MeshValues onto);
  /// Adds to `flows` the derivatives of the mesh values at the beads, interpolated with their windows and
  /// divided by the volume of a mesh cell.
  void (*gather_moments)(int order, const WindowMesh&, const WindowBeads&, ConstMeshValues from,
                         double* flows);

  static const MomentKernels baseline, x86_64_v3,
      x86_64_v4;  ///< of each instruction set (core/kernel.hpp)
};

}  // namespace beadswim
