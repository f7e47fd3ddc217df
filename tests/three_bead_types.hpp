#pragma once

#include "beadswim/swimmers/three_bead_swimmer.hpp"

namespace beadswim {

/// Calls edit(three) with the three-bead form of a driving or of a type, and stores the edited form.
inline void change(Driving& driving, auto&& edit) {
  ThreeBeadDriving three = three_bead_form(driving).value();
  edit(three);
  driving = drives(three);
}
inline void change(SwimmerType& type, auto&& edit) {
  ThreeBeadSwimmer three = three_beads(type);
  edit(three);
  type = swimmer_type(three);
}

inline void set_amplitude(Driving& driving, const std::array<double, 2>& amplitude) {
  change(driving, [&](ThreeBeadDriving& three) { three.amplitude = amplitude; });
}

inline void set_springs(SwimmerType& type, const Spring& spring) {
  change(type, [&](ThreeBeadSwimmer& three) { three.springs.fill(spring); });
}

}  // namespace beadswim
