#pragma once

#include <array>
#include <cstddef>
#include <cstdlib>
#include <memory>

#include "beadswim/lattice/block.hpp"
#include "beadswim/lattice/d3q19.hpp"
#include "beadswim/lattice/precision.hpp"

namespace beadswim {

/// Returns the vector from a cell to the next cell along direction i [cell].
inline Index3 lattice_vector(int i) {
  const auto& c = d3q19::velocity[i];
  return {c[0], c[1], c[2]};
}

/// Returns the velocity c_i of direction i [cell/step].
inline Vec3 velocity_of(int i) {
  return lattice_vector(i).cast<double>().matrix();
}

/// Treatment of the two halo cells at the ends of each row: the cell before its first cell and the cell after
/// its last cell along x. The sweep (streaming and collision) can fill them itself while the row is in the
/// cache.
enum class RowEnds {
  left_to_halo,  ///< the class Halo fills them, not the sweep
  wrapped,       ///< periodic images: x is periodic and not divided among ranks
  mirrored,      ///< mirror images: x ends in free-slip walls on both sides
};

/// Populations that are filled in a halo cell h, for each of the five directions i that point from h into the
/// block. ibar is the direction opposite to i. An outgoing population leaves its cell in the next streaming;
/// an incoming population enters its cell.
enum class HaloContent {
  entering,  ///< outgoing population i of h
  /// Outgoing populations i and ibar and incoming population i of h. The incoming population i of h is the
  /// outgoing population i of the cell at h - c_i, on the side of h that is away from the block. If x is
  /// periodic and not divided among ranks, only outgoing population i is filled in halo cells across x,
  /// because the other populations can be read at the other end of the row.
  behind,
};

/// Returns the smallest permitted number of cells of a block along each axis.
constexpr int min_thickness(HaloContent content) {
  return content == HaloContent::behind ? 2 : 1;
}

/// Populations of one block and of its halo, a layer around the block that is one cell wide. They are stored
/// after collision, as deviations f_i - w_i from their weight, in one array per direction with x fastest. The
/// 19 populations that a collision leaves in a cell are its outgoing populations. Streaming moves them to the
/// neighbours, where they are incoming populations. There is only one copy of each population.
///
/// A step reads the 19 incoming populations of a cell and writes its 19 outgoing populations to the same 19
/// addresses. The rule that assigns an address to a population therefore alternates from step to step between
/// two rules, called parities (docs/method/in-place-streaming.md). ibar is the direction opposite to i:
///
///   parity    outgoing i of cell x      incoming i of cell x
///   local     array ibar, at x          array ibar, at x - c_i
///   streamed  array i, at x + c_i       array i, at x
///
/// Only the accessors of this class depend on the parity. At both parities, the incoming population i of cell
/// x is the outgoing population i of its neighbour at x - c_i.
///
/// A cell is identified by its index in these arrays, which cell() returns. Local coordinates run from -1 to
/// size along each axis. The cells 0 to size - 1 belong to the block, the others to the halo.
class Populations {
 public:
  /// Sets all deviations to zero: fluid of density 1 at rest.
  explicit Populations(const Index3& size, Precision precision = Precision::fp64,
                       HaloContent halo = HaloContent::entering);

  Precision precision() const { return precision_; }
  const Index3& size() const { return size_; }
  std::ptrdiff_t cell(int x, int y, int z) const {
    return first_ + x + pitch_y_ * (y + 1) + pitch_z_ * (z + 1);
  }
  std::ptrdiff_t cell(const Index3& p) const { return cell(p[0], p[1], p[2]); }

  /// Return the index of the next cell along direction i (shift) or along an axis (pitch), minus the index of
  /// the cell itself.
  std::ptrdiff_t shift(int i) const { return shift_[i]; }
  std::ptrdiff_t pitch(int axis) const { return axis == 0 ? 1 : (axis == 1 ? pitch_y_ : pitch_z_); }

  /// Returns the population that leaves `cell` along direction i in the next streaming.
  double outgoing(int i, std::ptrdiff_t cell) const { return number(place_[parity_][i] + cell); }

  /// Returns the population that `cell` receives along direction i in the next streaming. On a link that ends
  /// at a wall or bead, the boundary condition sets it.
  double incoming(int i, std::ptrdiff_t cell) const { return outgoing(i, cell - shift_[i]); }

  /// Sets a population. Returns the stored value, which is f rounded to the precision of the populations.
  double set_outgoing(int i, std::ptrdiff_t cell, double f) {
    if (is_row_end(cell)) row_ends_filled_ = RowEnds::left_to_halo;
    return store(place_[parity_][i] + cell, f);
  }

  // The following functions return the address of a population of cell `first`, for loops along rows: the
  // same population of the next cell along x follows in memory. Real is the type that
  // in_precision(precision()) selects.

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

  /// Returns the address to which the collision in the present step writes outgoing population i of cell
  /// `first`. At this address lies one of the incoming populations of the same cell.
  template <class Real>
  Real* next_outgoing_row(int i, std::ptrdiff_t first) {
    return numbers<Real>() + place_[1 - parity_][i] + first;
  }

  /// Changes the parity, the rule for the addresses of populations, after all cells have been swept. The
  /// values at next_outgoing_row() become the outgoing populations. `row_ends`: treatment of the row ends by
  /// this sweep.
  void advance(RowEnds row_ends) {
    parity_ = 1 - parity_;
    row_ends_filled_ = row_ends;
  }

  /// Returns the treatment of the row ends that the last sweep applied, or left_to_halo if set_outgoing() has
  /// since changed the first or last cell of a row.
  RowEnds row_ends_filled() const { return row_ends_filled_; }

  /// Returns the memory that the populations of a block of this size occupy [byte].
  static std::size_t bytes_of(const Index3& size, Precision precision, HaloContent halo) {
    return d3q19::directions * pitches_of(size, precision, halo).direction * bytes_per_population(precision);
  }

 private:
  /// Distances of rows, planes and arrays, and the index of the cell (0, -1, -1).
  struct Pitches {
    std::ptrdiff_t y, z, direction, first;
  };
  static Pitches pitches_of(const Index3& size, Precision precision, HaloContent halo);

  struct Free {
    void operator()(void* p) const { std::free(p); }
  };

  template <class Real>
  Real* numbers() const {
    return static_cast<Real*>(data_.get());
  }
  bool is_row_end(std::ptrdiff_t cell) const {
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
  /// Position in `data_` of outgoing population i of the cell with index 0, as [parity][i].
  std::array<std::array<std::ptrdiff_t, d3q19::directions>, 2> place_;
  int parity_ = 1;  ///< 0: local, 1: streamed
  RowEnds row_ends_filled_ = RowEnds::left_to_halo;
  std::unique_ptr<void, Free> data_;
};

/// Density minus 1 and momentum of the fluid in one cell, in lattice units. A collision does not change them.
struct CellMoments {
  double density_deviation = 0;
  Vec3 momentum = Vec3::Zero();
};
CellMoments cell_moments(const Populations& populations, std::ptrdiff_t cell);

/// Calls visit(local coordinates, cell index) for every cell of the block except the halo, x fastest.
template <class Visit>
void for_each_cell(const Populations& populations, Visit&& visit) {
  for_each_cell(Block{.size = populations.size()}, [&](const Index3& p) { visit(p, populations.cell(p)); });
}

}  // namespace beadswim
