#pragma once

#include <cmath>

#include "kernel_vectors.hpp"
#include "mobility_kernels.hpp"

// Only for files that are compiled once per instruction set. BEADSWIM_INSTRUCTION_SET is the namespace of the
// instruction set.

namespace beadswim::BEADSWIM_INSTRUCTION_SET {

/// Window of a bead: the mesh points along each axis that receive its force, their weights W, and the
/// derivatives of the weights up to the order `highest` by the mesh coordinate. The weights are padded with
/// zeros to `size`, a multiple of 4.
template <int size, int highest>
struct Window {
  static constexpr int quads = size / quad;
  int first[3];
  int planes[size], rows[size], columns[size];  ///< periodic indices; a plane is -1 if another rank owns it
  double weight[highest + 1][3][size];          ///< [derivative][axis][point] [1/length^(derivative + 1)]

  BEADSWIM_KERNEL void set_position(const WindowMesh& mesh, const double* position) {
    const int P = mesh.window;
    double variable[3];
    for (int a = 0; a < 3; ++a) {
      double place = (position[a] - mesh.origin[a]) * mesh.inverse_spacing[a];
      // Wraps the position into the periodic mesh, so that its index fits into an int.
      place -= mesh.points[a] * std::floor(place * mesh.inverse_points[a]);
      const double from_start = place - 0.5 * P, below = std::floor(from_start);
      const bool is_on_mesh = below >= -P && below < mesh.points[a];  // false for NaN
      first[a] = wrapped((is_on_mesh ? static_cast<int>(below) : 0) + 1, mesh.points[a]);
      variable[a] = 2 * (below + 1 - from_start) - 1;
    }
    const int degree = mesh.degree;
#pragma GCC unroll 5
    for (int k = 0; k <= highest; ++k) {
      const double* const table = mesh.polynomials + k * (degree + 1) * size;
      Quad sum[3][quads];
      for (int g = 0; g < quads; ++g)
        sum[0][g] = sum[1][g] = sum[2][g] = load_as<Quad>(table + degree * size + quad * g);
#pragma GCC unroll 1
      for (int power = degree - 1; power >= 0; --power) {
#pragma GCC unroll 5
        for (int g = 0; g < quads; ++g) {
          const Quad next = load_as<Quad>(table + power * size + quad * g);
          for (int a = 0; a < 3; ++a) sum[a][g] = sum[a][g] * variable[a] + next;
        }
      }
      for (int a = 0; a < 3; ++a) {
        double unit = mesh.inverse_spacing[a];
        for (int n = 0; n < k; ++n) unit *= mesh.inverse_spacing[a];
        for (int g = 0; g < quads; ++g) store_as(weight[k][a] + quad * g, unit * sum[a][g]);
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
    return first[2] + size > mesh.points[2];
  }
  BEADSWIM_KERNEL long row(const WindowMesh& mesh, int p, int q) const {
    return (static_cast<long>(planes[p]) * mesh.points[1] + rows[q]) * mesh.row_length;
  }
};

}  // namespace beadswim::BEADSWIM_INSTRUCTION_SET
