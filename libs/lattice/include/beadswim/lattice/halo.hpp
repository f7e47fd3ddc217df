#pragma once

#include <array>
#include <cstddef>
#include <set>
#include <vector>

#include "beadswim/core/box.hpp"
#include "beadswim/core/communicator.hpp"
#include "beadswim/lattice/block.hpp"
#include "beadswim/lattice/populations.hpp"

namespace beadswim {

/// Fills the halo of a block, its layer of ghost cells, before each time step. The populations come from
/// neighbouring ranks, from the block itself (along a periodic axis that is not divided among ranks) or from
/// the condition at a wall. A free-slip wall mirrors populations. A no-slip wall bounces them back, so that
/// the fluid has the velocity of the wall half a cell outside the last cell.
///
/// The halo is filled axis by axis, in the order x, y, z. A halo plane perpendicular to one axis includes the
/// halo cells of the preceding axes, so that edges and corners need no separate treatment. The bounce-back at
/// no-slip walls needs only populations of the cell itself and comes last. HaloContent lists the populations
/// that are filled in a halo cell. All other populations of the halo, and all populations behind a no-slip
/// wall, are unspecified.
///
/// Messages between neighbours along z may be in transit while the inner planes of constant z are swept
/// (fluid_step.hpp), because only the outer planes read the halo beyond the faces perpendicular to z. With
/// HaloContent::behind, start() waits for all messages.
class Halo {
 public:
  /// Requires blocks of at least min_thickness(content). Populations that this object fills must have been
  /// constructed with the same `content`. `at_interface`: axes along which the lattice ends at a coarser
  /// level instead of at a boundary (level_interface.hpp); the halo beyond these ends is not filled.
  Halo(const Communicator& communicator, const Decomposition& decomposition,
       const std::array<Boundary, 3>& boundary, HaloContent content = HaloContent::entering,
       const std::array<bool, 3>& at_interface = {});
  ~Halo();

  Halo(const Halo&) = delete;
  Halo& operator=(const Halo&) = delete;

  /// Sets the velocities of the no-slip walls at the ends of an axis, which are zero by default (lattice
  /// units).
  void set_wall_velocities(int axis, const WallVelocities& walls) {
    faces_[axis][0].wall_velocity = walls.lower;
    faces_[axis][1].wall_velocity = walls.upper;
  }

  /// Fills all halo cells except those that need a message from a neighbour along z. Sends the messages to
  /// the neighbours along z.
  void start(Populations& populations);

  /// Lets MPI progress the pending messages. Call it repeatedly between start() and finish(): MPI need not
  /// progress messages by itself.
  void progress();

  /// Receives the messages from the neighbours along z and fills the remaining halo cells. Between start()
  /// and finish(), the caller may sweep all rows except the rows of the outermost planes along z. It may
  /// apply the boundary condition on a bead link if the link uses no population that enters a cell at a wall
  /// or through a face perpendicular to z.
  void finish(Populations& populations);

  const Traffic& traffic() const { return traffic_; }

  /// Returns the other ranks that exchange halo cells with this rank.
  std::set<int> neighbours() const;

  /// Returns how a sweep can fill the two halo cells at the ends of each row (along x) for the next step. If
  /// the last sweep has filled these halo cells, start() does not fill them again.
  RowEnds row_ends() const;

 private:
  struct Face {
    Boundary closed_by = Boundary::periodic;  ///< periodic: open to a neighbouring block
    bool at_interface = false;                ///< the face ends the lattice; beyond it is a coarser level
    Vec3 wall_velocity = Vec3::Zero();        ///< of a no-slip wall
    int neighbour = MPI_PROC_NULL;            ///< rank of the block beyond the face; may be this rank
    std::vector<std::byte> send, receive;

    bool is_open() const { return closed_by == Boundary::periodic && !at_interface; }
  };

  bool at_wall(int axis, int side, Boundary wall) const {
    return faces_[axis][side].closed_by == wall && !faces_[axis][side].at_interface;
  }

  /// Returns true if the neighbour beyond one of the two faces perpendicular to `axis` is another rank.
  bool is_cut(int axis) const {
    return faces_[axis][0].neighbour != rank_ && (faces_[axis][0].is_open() || faces_[axis][1].is_open());
  }

  void bounce_back_at_walls(Populations& populations, int low_z, int high_z);
  void start_across(Populations& populations, HaloContent content, int axis);
  void send(const Populations& populations, HaloContent content, int axis);
  void receive(Populations& populations, HaloContent content, int axis);

  MPI_Comm comm_;
  int rank_;
  HaloContent content_;
  std::array<std::array<Face, 2>, 3> faces_;  ///< [axis][0: low side, 1: high side]
  std::array<MPI_Request, 4> messages_;       ///< send and receive requests of one axis
  bool has_pending_messages_ = false;         ///< messages along z are in transit
  Traffic traffic_;
};

}  // namespace beadswim
