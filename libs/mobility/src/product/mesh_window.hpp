#pragma once

#include <cmath>

#include "beadswim/core/kernel.hpp"
#include "mobility_kernels.hpp"

// Only for files that are compiled once per instruction set. BEADSWIM_INSTRUCTION_SET is the namespace of the
// instruction set.

namespace beadswim::BEADSWIM_INSTRUCTION_SET {

/// Window of a bead: the P mesh points along each axis that receive its Gaussian, and their weights.
template <int P>
struct Window {
  int first[3];
  double weight[3][P];
  double offset[3];        ///< from the bead to the first point [mesh spacing]
  int planes[P], rows[P];  ///< periodic indices; a plane is -1 if another rank owns it

  BEADSWIM_KERNEL void set_position(const WindowMesh& mesh, const double* position) {
    for (int a = 0; a < 3; ++a) {
      double place = (position[a] - mesh.origin[a]) * mesh.inverse_spacing[a];
      // Wraps the position into the periodic mesh, so that its index fits into an int.
      place -= mesh.points[a] * std::floor(place * mesh.inverse_points[a]);
      const double below = std::floor(place);
      const bool is_on_mesh = below >= 0 && below < mesh.points[a];  // false for NaN
      first[a] = (is_on_mesh ? static_cast<int>(below) : 0) - P / 2 + 1;
      // Gaussian at window point p: exp(-c (d + p)^2) = exp(-c d^2) exp(-2 c d)^p exp(-c p^2)
      const double d = below - P / 2 + 1 - place;
      offset[a] = d;
      double power = mesh.height[a] * std::exp(-mesh.decay[a] * d * d);
      const double ratio = std::exp(-2 * mesh.decay[a] * d);
      for (int p = 0; p < P; ++p) {
        weight[a][p] = power * mesh.decay_at[a][p];
        power *= ratio;
      }
      first[a] = wrapped(first[a], mesh.points[a]);
    }
    for (int p = 0; p < P; ++p) {
      planes[p] = wrapped(first[0] + p, mesh.points[0]) - mesh.first_plane;
      if (planes[p] >= mesh.planes) planes[p] = -1;
      rows[p] = wrapped(first[1] + p, mesh.points[1]);
    }
  }
  BEADSWIM_KERNEL static int wrapped(int index, int points) {
    if (index >= 0 && index < points) return index;
    const int rest = index % points;
    return rest < 0 ? rest + points : rest;
  }
  BEADSWIM_KERNEL bool wraps(const WindowMesh& mesh) const { return first[2] + P > mesh.points[2]; }
  BEADSWIM_KERNEL long row(const WindowMesh& mesh, int p, int q) const {
    return (static_cast<long>(planes[p]) * mesh.points[1] + rows[q]) * mesh.row_length;
  }
};

/// Calls work<P>() for a window of P points along an axis, P = 4, 6, .., max_points.
template <int P = 4, class Work>
BEADSWIM_KERNEL void with_window(int window, const Work& work) {
  if (window == P) {
    work.template operator()<P>();
  } else if constexpr (P < WindowMesh::max_points) {
    with_window<P + 2>(window, work);
  }
}

/// Adds the three values of each bead, multiplied by the weights of its window, to the three meshes.
void spread_windows(const WindowMesh& mesh, const WindowBeads& beads, const double* numbers,
                    double* const* onto);
/// Adds to the three values of each bead the sums of the mesh values, multiplied by the weights of its
/// window.
void gather_windows(const WindowMesh& mesh, const WindowBeads& beads, const double* const* from,
                    double* numbers);

}  // namespace beadswim::BEADSWIM_INSTRUCTION_SET
