#pragma once

#include <array>
#include <cstddef>
#include <cstdlib>
#include <memory>
#include <utility>

#include "beadswim/core/vec3.hpp"
#include "beadswim/lattice/d3q19.hpp"

namespace beadswim {

/// The populations of one block and of a halo one cell wide: deviations f_i - w_i after collision, as one
/// plain array a direction, x fastest. A second copy receives the next step.
///
/// Cells are named by their index in such an array; local coordinates run from -1 to size, 0 to size-1 being
/// the block's own.
class Populations {
 public:
  /// All deviations start at zero: fluid of density 1 at rest.
  explicit Populations(const Index3& size);

  const Index3& size() const { return size_; }
  std::ptrdiff_t cell(int x, int y, int z) const { return (x + 1) + pitch_y_ * (y + 1) + pitch_z_ * (z + 1); }
  std::ptrdiff_t cell(const Index3& p) const { return cell(p[0], p[1], p[2]); }
  std::ptrdiff_t cells_with_halo() const { return pitch_z_ * (size_[2] + 2); }

  /// Distance in memory from a cell to its neighbour along direction i, or along an axis.
  std::ptrdiff_t shift(int i) const { return shift_[i]; }
  std::ptrdiff_t pitch(int axis) const { return axis == 0 ? 1 : (axis == 1 ? pitch_y_ : pitch_z_); }

  /// What leaves `cell` along direction i in the coming streaming.
  double& outgoing(int i, std::ptrdiff_t cell) { return now_[i * pitch_i_ + cell]; }
  double outgoing(int i, std::ptrdiff_t cell) const { return now_[i * pitch_i_ + cell]; }

  /// The place from which `cell` will receive direction i in the coming streaming. Where a link ends at a
  /// wall or bead, the boundary condition writes here.
  double& incoming(int i, std::ptrdiff_t cell) { return now_[i * pitch_i_ + cell - shift_[i]]; }

  /// Array of direction i, now and for the next step.
  double* direction(int i) { return now_.get() + i * pitch_i_; }
  const double* direction(int i) const { return now_.get() + i * pitch_i_; }
  double* next_direction(int i) { return next_.get() + i * pitch_i_; }

  /// The next step's populations become the present ones.
  void advance() { std::swap(now_, next_); }

 private:
  struct Free {
    void operator()(double* p) const { std::free(p); }
  };
  using Array = std::unique_ptr<double[], Free>;
  static Array zeros(std::ptrdiff_t count);

  Index3 size_;
  std::ptrdiff_t pitch_y_, pitch_z_, pitch_i_;
  std::array<std::ptrdiff_t, d3q19::directions> shift_;
  Array now_, next_;
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
