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

/// Fills the halo of a block before each step. The populations come from neighbouring ranks, from the block
/// itself (a periodic axis that is not divided among ranks) or from the wall condition. A free-slip wall
/// mirrors populations. A no-slip wall bounces them back, so that the velocity vanishes half a cell outside
/// the last cell.
///
/// The axes are filled one after the other. Each axis includes the halo cells that are already filled, so
/// that edges and corners need no separate treatment. No-slip walls are local to a cell and come last. Only
/// the five directions that enter the block through a face are filled in the halo cells of this face. All
/// other populations of the halo, and all populations behind a no-slip wall, are unspecified.
///
/// Messages across z may be in transit while the inner planes are swept (fluid_step.hpp), because only planes
/// near the halo read it. With HaloContent::behind, start() completes all messages.
class Halo {
 public:
  /// Throws InputError if `content` is `behind` and a block is only one cell thick. The populations that are
  /// filled must have been constructed for the same content.
  Halo(const Communicator& communicator, const Decomposition& decomposition,
       const std::array<Boundary, 3>& boundary, HaloContent content = HaloContent::entering);
  ~Halo();

  Halo(const Halo&) = delete;
  Halo& operator=(const Halo&) = delete;

  /// Fills all halo cells that need no message across z, and sends the messages across z.
  void start(Populations& populations);

  /// Lets MPI progress the pending messages. Call it repeatedly between start() and finish(): MPI need not
  /// progress messages by itself.
  void progress();

  /// Receives the messages across z and fills the remaining halo cells. Since start(), the caller may have
  /// swept rows, except those of the outermost planes. It may have processed links, except links that use
  /// populations which enter through a face across z or at a wall.
  void finish(Populations& populations);

  /// Fills the complete halo.
  void fill(Populations& populations) {
    start(populations);
    finish(populations);
  }

  /// Returns the messages that have been sent so far.
  const Traffic& traffic() const { return traffic_; }

  /// Returns the other ranks that exchange halo cells with this rank.
  std::set<int> neighbours() const;

  /// Returns the treatment of the row ends that the preceding sweep can apply. If the sweep has applied it,
  /// fill() skips the halo across x.
  RowEnds row_ends() const;

 private:
  struct Face {
    Boundary closed_by = Boundary::periodic;  ///< periodic: the face is open to a neighbour
    int neighbour = MPI_PROC_NULL;            ///< rank across an open face; this rank if periodic in itself
    std::vector<std::byte> send, receive;

    bool is_open() const { return closed_by == Boundary::periodic; }
  };

  bool at_wall(int axis, int side, Boundary wall) const { return faces_[axis][side].closed_by == wall; }

  /// Returns true if the neighbour across a face of this axis is another rank.
  bool is_cut(int axis) const {
    return faces_[axis][0].neighbour != rank_ && (faces_[axis][0].is_open() || faces_[axis][1].is_open());
  }

  template <class Real>
  void start_as(Populations& populations);
  template <class Real>
  void bounce_back_at_walls(Populations& populations, int low_z, int high_z);
  template <class Real>
  void start_across(Populations& populations, HaloContent content, int axis);
  template <class Real>
  void send(const Populations& populations, HaloContent content, int axis);
  template <class Real>
  void receive(Populations& populations, HaloContent content, int axis);

  MPI_Comm comm_;
  int rank_;
  HaloContent content_;
  std::array<std::array<Face, 2>, 3> faces_;  ///< [axis][0: low side, 1: high side]
  std::array<MPI_Request, 4> messages_;       ///< send and receive requests of one axis
  bool has_pending_messages_ = false;         ///< messages across z are pending
  Traffic traffic_;
};

}  // namespace beadswim
