#pragma once

#include <cmath>

#include "kernel_vectors.hpp"
#include "mobility_kernels.hpp"

// Only for files that are compiled once per instruction set. BEADSWIM_INSTRUCTION_SET is the namespace of the
// instruction set.

namespace beadswim::BEADSWIM_INSTRUCTION_SET {

/// Returns the number of points with the padding to whole vectors.
BEADSWIM_KERNEL int padded(int points) {
  return (points + quad - 1) / quad * quad;
}

/// Window of a bead: the mesh points along each axis that receive its Gaussian, their weights W, and the
/// derivatives of the weights up to the order `highest` by the mesh coordinate. With the slope g of the
/// exponent of W, derivative k is h_k W, where h_(k+1) = g h_k + k g' h_(k-1). The weights are padded with
/// zeros to whole vectors.
template <int highest>
struct Window {
  static constexpr int size = WindowMesh::max_points;
  int first[3];
  int planes[size], rows[size], columns[size];  ///< periodic indices; a plane is -1 if another rank owns it
  double weight[highest + 1][3][size];          ///< [derivative][axis][point] [1/length^(derivative + 1)]

  BEADSWIM_KERNEL void set_position(const WindowMesh& mesh, const double* position) {
    const int P = mesh.window;
    for (int a = 0; a < 3; ++a) {
      double place = (position[a] - mesh.origin[a]) * mesh.inverse_spacing[a];
      // Wraps the position into the periodic mesh, so that its index fits into an int.
      place -= mesh.points[a] * std::floor(place * mesh.inverse_points[a]);
      const double below = std::floor(place);
      const bool is_on_mesh = below >= 0 && below < mesh.points[a];  // false for NaN
      first[a] = wrapped((is_on_mesh ? static_cast<int>(below) : 0) - P / 2 + 1, mesh.points[a]);
      // Gaussian at window point p: exp(-c (d + p)^2) = exp(-c d^2) exp(-2 c d)^p exp(-c p^2)
      const double d = below - P / 2 + 1 - place;
      double power = mesh.height[a] * std::exp(-mesh.decay[a] * d * d);
      const double ratio = std::exp(-2 * mesh.decay[a] * d);
      for (int p = 0; p < padded(P); ++p) {
        weight[0][a][p] = power * mesh.decay_at[a][p];
        power *= ratio;
      }
      const double slope = -2 * mesh.decay[a] * mesh.inverse_spacing[a],  // g = slope (d + p)
          curve = slope * mesh.inverse_spacing[a];                        // g'
      for (int p = 0; p < padded(P) && highest > 0; ++p) {
        const double g = slope * (d + p);
        double h = g, h_below = 1;
#pragma GCC unroll 4
        for (int k = 1; k <= highest; ++k) {
          weight[k][a][p] = h * weight[0][a][p];
          const double next = g * h + k * curve * h_below;
          h_below = h;
          h = next;
        }
      }
    }
    for (int p = 0; p < P; ++p) {
      planes[p] = wrapped(first[0] + p, mesh.points[0]) - mesh.first_plane;
      if (planes[p] >= mesh.planes) planes[p] = -1;
      rows[p] = wrapped(first[1] + p, mesh.points[1]);
      columns[p] = wrapped(first[2] + p, mesh.points[2]);
    }
  }
  BEADSWIM_KERNEL static int wrapped(int index, int points) {
    if (index >= 0 && index < points) return index;
    const int rest = index % points;
    return rest < 0 ? rest + points : rest;
  }
  /// Returns true if a padded row crosses the end of a row of the mesh.
  BEADSWIM_KERNEL bool wraps(const WindowMesh& mesh) const {
    return first[2] + padded(mesh.window) > mesh.points[2];
  }
  BEADSWIM_KERNEL long row(const WindowMesh& mesh, int p, int q) const {
    return (static_cast<long>(planes[p]) * mesh.points[1] + rows[q]) * mesh.row_length;
  }
};

}  // namespace beadswim::BEADSWIM_INSTRUCTION_SET
