#pragma once

#include <array>
#include <cstddef>
#include <cstdlib>
#include <memory>

#include "beadswim/core/vec3.hpp"
#include "beadswim/lattice/d3q19.hpp"
#include "beadswim/lattice/precision.hpp"

namespace beadswim {

/// What a sweep does for the halo cells before and after each row, as long as the row is at hand in the
/// cache.
enum class RowEnds {
  left_to_halo,
  wrapped,   ///< x is periodic and not cut: what leaves at one end enters at the other
  mirrored,  ///< x ends in free-slip walls on both sides
};

/// Which numbers of a halo cell h are filled, for each of the five directions i that enter the block from it.
enum class HaloContent {
  entering,  ///< outgoing i
  /// Outgoing i and outgoing ibar of h, and incoming i of h: outgoing i of the cell behind it. Along an x
  /// that is periodic and not cut only outgoing i, as the rest is at hand at the other end of the row.
  behind,
};

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
/// The accessors know it; nothing else does. At either parity the incoming i of a cell is the outgoing i of
/// its neighbour at x - c_i.
///
/// Cells are named by their index in such an array; local coordinates run from -1 to size, 0 to size-1 being
/// the block's own.
class Populations {
 public:
  /// All deviations start at zero: fluid of density 1 at rest.
  explicit Populations(const Index3& size, Precision precision = Precision::fp64,
                       HaloContent halo = HaloContent::entering);

  Precision precision() const { return precision_; }
  const Index3& size() const { return size_; }
  std::ptrdiff_t cell(int x, int y, int z) const {
    return first_ + x + pitch_y_ * (y + 1) + pitch_z_ * (z + 1);
  }
  std::ptrdiff_t cell(const Index3& p) const { return cell(p[0], p[1], p[2]); }

  /// Distance in memory from a cell to its neighbour along direction i, or along an axis.
  std::ptrdiff_t shift(int i) const { return shift_[i]; }
  std::ptrdiff_t pitch(int axis) const { return axis == 0 ? 1 : (axis == 1 ? pitch_y_ : pitch_z_); }

  /// What leaves `cell` along direction i in the coming streaming.
  double outgoing(int i, std::ptrdiff_t cell) const { return number(place_[parity_][i] + cell); }

  /// What `cell` will receive along direction i in the coming streaming. Where a link ends at a wall or bead,
  /// the boundary condition sets it.
  double incoming(int i, std::ptrdiff_t cell) const { return outgoing(i, cell - shift_[i]); }

  /// Both return the number as it is stored, rounded to the precision.
  double set_outgoing(int i, std::ptrdiff_t cell, double f) {
    if (ends_a_row(cell)) row_ends_filled_ = RowEnds::left_to_halo;
    return store(place_[parity_][i] + cell, f);
  }
  double set_incoming(int i, std::ptrdiff_t cell, double f) {
    return store(place_[parity_][i] + cell - shift_[i], f);
  }

  // The same as places in memory, for loops along rows, in which cells follow one another. Real: the type
  // that in_precision(precision()) names.

  template <class Real>
  Real* outgoing_row(int i, std::ptrdiff_t first) {
    return numbers<Real>() + place_[parity_][i] + first;
  }
  template <class Real>
  const Real* outgoing_row(int i, std::ptrdiff_t first) const {
    return numbers<Real>() + place_[parity_][i] + first;
  }
  template <class Real>
  Real* incoming_row(int i, std::ptrdiff_t first) {
    return outgoing_row<Real>(i, first - shift_[i]);
  }

  /// Where cells will put what leaves them along direction i in the step after: among the places of their
  /// incoming populations.
  template <class Real>
  Real* next_outgoing_row(int i, std::ptrdiff_t first) {
    return numbers<Real>() + place_[1 - parity_][i] + first;
  }

  /// All cells have been stepped: what they put in next_outgoing_row is outgoing now.
  void advance(RowEnds row_ends) {
    parity_ = 1 - parity_;
    row_ends_filled_ = row_ends;
  }

  /// What the last sweep put into the halo cells at the two ends of each row and still holds.
  RowEnds row_ends_filled() const { return row_ends_filled_; }

  /// Bytes of memory that the populations take.
  std::size_t bytes() const { return bytes_; }

 private:
  struct Free {
    void operator()(void* p) const { std::free(p); }
  };

  template <class Real>
  Real* numbers() const {
    return static_cast<Real*>(data_.get());
  }
  bool ends_a_row(std::ptrdiff_t cell) const {
    const std::ptrdiff_t x = (cell - first_) % pitch_y_;
    return x == 0 || x == size_[0] - 1;
  }
  double number(std::ptrdiff_t place) const {
    return in_precision(precision_,
                        [&]<class Real>() { return static_cast<double>(numbers<Real>()[place]); });
  }
  double store(std::ptrdiff_t place, double f) {
    return in_precision(
        precision_, [&]<class Real>() -> double { return numbers<Real>()[place] = static_cast<Real>(f); });
  }

  Precision precision_;
  Index3 size_;
  std::ptrdiff_t first_, pitch_y_, pitch_z_;
  std::array<std::ptrdiff_t, d3q19::directions> shift_;
  std::array<std::array<std::ptrdiff_t, d3q19::directions>, 2> place_;  ///< [parity][i]: outgoing i of cell 0
  int parity_ = 1;                                                      ///< 0: local, 1: streamed
  RowEnds row_ends_filled_ = RowEnds::left_to_halo;
  std::size_t bytes_;
  std::unique_ptr<void, Free> data_;
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
