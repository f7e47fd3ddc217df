#pragma once

#include <array>
#include <cstddef>
#include <set>
#include <vector>

#include "beadswim/core/box.hpp"
#include "beadswim/core/communicator.hpp"
#include "beadswim/core/traffic.hpp"
#include "beadswim/lattice/block.hpp"
#include "beadswim/lattice/populations.hpp"

namespace beadswim {

/// Fills the halo of a block before each step: from neighbouring ranks, from the block itself where a
/// periodic axis is not cut, and by the wall's rule where the lattice ends: free-slip walls mirror, and
/// no-slip walls bounce back, fluid at rest half a cell outside the last cell.
///
/// Axis by axis, each over the halo already filled, so that edges and corners need no case of their own;
/// no-slip walls, which are local to a cell, come last. Only the five directions that enter the block through
/// a face are filled there; the rest of the halo is unspecified, and so is what lies behind a no-slip wall.
///
/// Messages across z may be under way while the planes inside are swept (fluid_step.hpp), unless the halo
/// holds what is behind: only planes near the halo need it.
class Halo {
 public:
  /// Throws InputError if a block is a single cell thick and content is `behind`. The populations that it
  /// fills must have been made for this content.
  Halo(const Communicator& communicator, const Decomposition& decomposition,
       const std::array<Boundary, 3>& boundary, HaloContent content = HaloContent::entering);
  ~Halo();

  Halo(const Halo&) = delete;
  Halo& operator=(const Halo&) = delete;

  /// Fills all that needs no message across z, and sends these.
  void start(Populations& populations);

  /// Moves messages on. Call it now and then: MPI need not do so by itself.
  void progress();

  /// Fills the rest. Rows other than those of the outermost planes may have been swept since start(), and
  /// links done that touch nothing which enters through a face across z or stands at a wall.
  void finish(Populations& populations);

  /// Fills everything.
  void fill(Populations& populations) {
    start(populations);
    finish(populations);
  }

  /// Sent so far.
  const Traffic& traffic() const { return traffic_; }

  /// Other ranks across open faces.
  std::set<int> neighbours() const;

  /// What of this the sweep before can do, row by row: fill() then leaves it.
  RowEnds row_ends() const;

 private:
  struct Face {
    Boundary closed_by = Boundary::periodic;  ///< periodic: open to a neighbour
    int neighbour = MPI_PROC_NULL;  ///< rank across an open face; this rank if the block is its own image
    std::vector<std::byte> send, receive;

    bool is_open() const { return closed_by == Boundary::periodic; }
  };

  bool at_wall(int axis, int side, Boundary wall) const { return faces_[axis][side].closed_by == wall; }

  /// Whether a face across the axis leads to another rank.
  bool is_cut(int axis) const {
    return faces_[axis][0].neighbour != rank_ && (faces_[axis][0].is_open() || faces_[axis][1].is_open());
  }

  template <class Real>
  void start_as(Populations& populations);
  template <class Real>
  void bounce_back_at_walls(Populations& populations, int low_z, int high_z);
  template <class Real>
  void start_across(Populations& populations, HaloContent together, int axis);
  template <class Real>
  void send(const Populations& populations, HaloContent together, int axis);
  template <class Real>
  void receive(Populations& populations, HaloContent together, int axis);

  MPI_Comm comm_;
  int rank_;
  HaloContent content_;
  std::array<std::array<Face, 2>, 3> faces_;  ///< [axis][0: low side, 1: high side]
  std::array<MPI_Request, 4> messages_;       ///< across one axis
  bool is_under_way_ = false;                 ///< messages across z
  Traffic traffic_;
};

}  // namespace beadswim
