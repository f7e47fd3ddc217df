#pragma once

#include "beadswim/coupling/swimmer_state.hpp"
#include "message.hpp"

// Swimmers as bytes.

namespace beadswim {

inline void put(OutgoingMessage& message, const BeadMotion& motion) {
  message.put(motion.position);
  message.put(motion.velocity);
  message.put(motion.angular_velocity);
}

inline void get(IncomingMessage& message, BeadMotion& motion) {
  message.get(motion.position);
  message.get(motion.velocity);
  message.get(motion.angular_velocity);
}

inline void put(OutgoingMessage& message, const SwimmerState& swimmer) {
  message.put(swimmer.id);
  message.put(swimmer.type);
  message.put(swimmer.initial_axis);
  for (int b = 0; b < 3; ++b) {
    put(message, swimmer.motion[b]);
    message.put(swimmer.held_mass[b]);
    message.put(swimmer.mass_source[b]);
    message.put(swimmer.last_impulse[b].force);
    message.put(swimmer.last_impulse[b].torque);
  }
}

inline void get(IncomingMessage& message, SwimmerState& swimmer) {
  message.get(swimmer.id);
  message.get(swimmer.type);
  message.get(swimmer.initial_axis);
  for (int b = 0; b < 3; ++b) {
    get(message, swimmer.motion[b]);
    message.get(swimmer.held_mass[b]);
    message.get(swimmer.mass_source[b]);
    message.get(swimmer.last_impulse[b].force);
    message.get(swimmer.last_impulse[b].torque);
  }
}

}  // namespace beadswim
