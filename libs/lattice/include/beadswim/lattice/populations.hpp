#pragma once

#include <array>
#include <cstddef>
#include <cstdlib>
#include <memory>

#include "beadswim/core/vec3.hpp"
#include "beadswim/lattice/d3q19.hpp"

namespace beadswim {

/// The populations of one block and of a halo one cell wide: deviations f_i - w_i after collision, as one
/// plain array a direction, x fastest, in a single copy.
///
/// A step reads 19 numbers a cell, its incoming populations, and writes its 19 outgoing ones to the same 19
/// places. Which places these are alternates from step to step (docs/method/in-place-streaming.md):
///
///   parity    outgoing i of cell x      incoming i of cell x
///   local     array ibar, at x          array ibar, at x - c_i
///   streamed  array i, at x + c_i       array i, at x
///
/// `outgoing` and `incoming` know it; nothing else does. At either parity the incoming i of a cell is the
/// outgoing i of its neighbour at x - c_i.
///
/// Cells are named by their index in such an array; local coordinates run from -1 to size, 0 to size-1 being
/// the block's own.
class Populations {
 public:
  /// All deviations start at zero: fluid of density 1 at rest.
  explicit Populations(const Index3& size);

  const Index3& size() const { return size_; }
  std::ptrdiff_t cell(int x, int y, int z) const {
    return first_ + x + pitch_y_ * (y + 1) + pitch_z_ * (z + 1);
  }
  std::ptrdiff_t cell(const Index3& p) const { return cell(p[0], p[1], p[2]); }

  /// Distance in memory from a cell to its neighbour along direction i, or along an axis.
  std::ptrdiff_t shift(int i) const { return shift_[i]; }
  std::ptrdiff_t pitch(int axis) const { return axis == 0 ? 1 : (axis == 1 ? pitch_y_ : pitch_z_); }

  /// What leaves `cell` along direction i in the coming streaming.
  double& outgoing(int i, std::ptrdiff_t cell) { return data_[place_[parity_][i] + cell]; }
  const double& outgoing(int i, std::ptrdiff_t cell) const { return data_[place_[parity_][i] + cell]; }

  /// The place from which `cell` will receive direction i in the coming streaming. Where a link ends at a
  /// wall or bead, the boundary condition writes here.
  double& incoming(int i, std::ptrdiff_t cell) { return outgoing(i, cell - shift_[i]); }

  /// Where `cell` will put what leaves it along direction i in the step after: among the places of its
  /// incoming populations.
  double* next_outgoing(int i, std::ptrdiff_t cell) { return &data_[place_[1 - parity_][i] + cell]; }

  /// All cells have been stepped: what they put in next_outgoing is outgoing now.
  void advance() { parity_ = 1 - parity_; }

  /// Cells have indices below this.
  std::ptrdiff_t cell_indices() const { return cell_indices_; }

  /// Bytes of memory that the populations take.
  std::size_t bytes() const { return bytes_; }

 private:
  struct Free {
    void operator()(double* p) const { std::free(p); }
  };

  Index3 size_;
  std::ptrdiff_t first_, pitch_y_, pitch_z_, cell_indices_;
  std::array<std::ptrdiff_t, d3q19::directions> shift_;
  std::array<std::array<std::ptrdiff_t, d3q19::directions>, 2> place_;  ///< [parity][i]: outgoing i of cell 0
  int parity_ = 1;                                                      ///< 0: local, 1: streamed
  std::size_t bytes_;
  std::unique_ptr<double[], Free> data_;
};

/// Density minus 1 and momentum of one cell (post-collision values equal pre-collision ones).
struct CellMoments {
  double density_deviation = 0;
  Vec3 momentum = Vec3::Zero();
};
CellMoments cell_moments(const Populations& populations, std::ptrdiff_t cell);

/// Sets a cell to equilibrium at density 1 + r and velocity u.
void set_equilibrium(Populations& populations, std::ptrdiff_t cell, double r, const Vec3& u);

/// Calls visit(local coordinates, cell) for every own cell of the block, x fastest.
template <class Visit>
void for_each_cell(const Populations& populations, Visit&& visit) {
  const Index3& n = populations.size();
  for (int z = 0; z < n[2]; ++z) {
    for (int y = 0; y < n[1]; ++y) {
      for (int x = 0; x < n[0]; ++x) visit(Index3(x, y, z), populations.cell(x, y, z));
    }
  }
}

}  // namespace beadswim
