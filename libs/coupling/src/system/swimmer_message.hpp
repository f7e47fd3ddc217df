#pragma once

#include "beadswim/core/message.hpp"

// What travels of swimmers and beads, in its order: the same list writes and reads.

namespace beadswim {

/// Motion: BeadMotion, const to write.
template <class Message, class Motion>
void transfer_motion(Message& message, Motion& motion) {
  message(motion.position, motion.velocity, motion.angular_velocity);
}

/// Swimmer: SwimmerState, const to write.
template <class Message, class Swimmer>
void transfer_swimmer(Message& message, Swimmer& swimmer) {
  message(swimmer.id, swimmer.type, swimmer.initial_axis, swimmer.held_mass, swimmer.mass_source,
          swimmer.firmness);
  for (int b = 0; b < 3; ++b) {
    transfer_motion(message, swimmer.motion[b]);
    message(swimmer.last_impulse[b].force, swimmer.last_impulse[b].torque);
    message(swimmer.inner_momentum[b].force, swimmer.inner_momentum[b].torque);
    message(swimmer.predicted[b].linear, swimmer.predicted[b].angular);
  }
}

/// Snapshot: SwimmerSnapshot, const to write.
template <class Message, class Snapshot>
void transfer_snapshot(Message& message, Snapshot& snapshot) {
  transfer_swimmer(message, snapshot.state);
  message(snapshot.under_way);
}

/// Bead: BeadOnLattice, const to write; its impulse stays behind.
template <class Message, class Bead>
void transfer_bead(Message& message, Bead& bead) {
  message(bead.name, bead.owner, bead.radius, bead.mass_source, bead.body, bead.firmness,
          bead.predicted.linear, bead.predicted.angular);
  transfer_motion(message, bead.motion);
}

}  // namespace beadswim
