#pragma once

#include <array>
#include <vector>

#include "beadswim/core/message.hpp"
#include "beadswim/coupling/bead_on_lattice.hpp"
#include "beadswim/swimmers/swimmer_dynamics.hpp"

namespace beadswim {

/// State of one swimmer, kept by the rank that owns it, in lattice units.
struct SwimmerState {
  int id = 0;
  int type = 0;  ///< index into CoupledScene::types
  /// Columns of the orientation at the start of the run (swimmers/swimmer_shape.hpp).
  std::array<Vec3, 3> initial_orientation{Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()};
  // One entry per bead:
  SwimmerMotion motion;
  /// Excess mass (density - 1) of fluid that each bead has covered and not yet returned through its links.
  std::vector<double> held_mass;
  /// Fluid mass that each link of a bead returns in the next step, divided by the weight of the link.
  std::vector<double> mass_source;
  SwimmerLoads last_impulse;             ///< impulses of the fluid on the beads in the previous step
  SwimmerLoads inner_momentum;           ///< momenta of the fluid within the beads (psm, saturated_cells.hpp)
  std::vector<BeadVelocity> predicted;   ///< velocities at the end of the next step without close beads
  std::vector<double> removed_fraction;  ///< Impulse::removed_fraction of the beads in the last step

  /// Returns a swimmer with this number of beads, all at rest at the origin.
  static SwimmerState of_beads(std::size_t beads) {
    SwimmerState swimmer;
    visit_bead_fields([&](const char*, auto& of_beads) { of_beads.resize(beads); }, swimmer);
    return swimmer;
  }

  Eigen::Matrix3d orientation_at_start() const {
    Eigen::Matrix3d orientation;
    for (int a = 0; a < 3; ++a) orientation.col(a) = initial_orientation[a];
    return orientation;
  }

  /// Returns the position of the bead in the middle of the list, bead 2 of three. The rank whose block
  /// contains it owns the swimmer.
  const Vec3& middle() const { return motion[motion.size() / 2].position; }

  static void visit_fields(auto&& visit, auto& swimmer) {
    visit("id", swimmer.id);
    visit("type", swimmer.type);
    visit("initial_orientation", swimmer.initial_orientation);
    visit_bead_fields(visit, swimmer);
  }

  /// Visits the fields with one entry per bead. state_sha256() hashes these fields.
  static void visit_bead_fields(auto&& visit, auto& swimmer) {
    visit("held_mass", swimmer.held_mass);
    visit("mass_source", swimmer.mass_source);
    visit("removed_fraction", swimmer.removed_fraction);
    visit("motion", swimmer.motion);
    visit("last_impulse", swimmer.last_impulse);
    visit("inner_momentum", swimmer.inner_momentum);
    visit("predicted", swimmer.predicted);
  }
};

/// Complete state of a swimmer between two steps.
struct SwimmerSnapshot {
  SwimmerState state;
  std::vector<Impulse> pending_impulses;  ///< impulses on its beads, not yet applied; sums over all ranks

  static void visit_fields(auto&& visit, auto& snapshot) {
    visit("state", snapshot.state);
    visit("pending_impulses", snapshot.pending_impulses);
  }
};

/// Returns the states or snapshots of swimmers as bytes. Only machines with the same byte order and sizes of
/// numbers can read these bytes.
template <class State>
std::vector<char> bytes_of(const std::vector<State>& states) {
  OutgoingMessage message;
  for (const State& state : states) message(state);
  return message.bytes();
}

/// Inverse of bytes_of(). Throws SolverError if the bytes are not valid.
template <class State>
std::vector<State> states_from_bytes(std::vector<char> bytes) {
  std::vector<State> states;
  IncomingMessage message(std::move(bytes));
  while (!message.is_at_end()) message(states.emplace_back());
  return states;
}

/// Returns the size of the snapshot of a swimmer with this number of beads [byte].
inline std::size_t snapshot_size(std::size_t beads) {
  return bytes_of(std::vector{SwimmerSnapshot{.state = SwimmerState::of_beads(beads),
                                              .pending_impulses = std::vector<Impulse>(beads)}})
      .size();
}

}  // namespace beadswim
