#pragma once

#include <array>
#include <span>

#include "beadswim/core/fields.hpp"
#include "beadswim/core/vec3.hpp"

// What one swimmer did in one cycle of its driving. See docs/method/stroke-fit.md.

namespace beadswim {

/// One swimmer at one time.
struct SwimmerSample {
  double time = 0;
  std::array<Vec3, 3> bead_positions;  ///< centres of beads 1, 2, 3, unwrapped [length]
  Vec3 mean_flow = Vec3::Zero();       ///< volume-mean velocity of fluid and beads [length/time]

  static void visit_fields(auto&& visit, auto& sample) {
    visit("time", sample.time);
    visit("bead_positions", sample.bead_positions);
    visit("mean_flow", sample.mean_flow);
  }
};

/// Means and stroke over one period, in the samples' units and in the frame of the box.
struct CycleStatistics {
  int index = 0;                  ///< 1 for the first cycle
  Vec3 velocity = Vec3::Zero();   ///< displacement of the mean bead position over the period / period
  Vec3 axis = Vec3::UnitX();      ///< unit vector: mean direction from bead 1 to bead 3
  double speed_along_axis = 0;    ///< velocity . axis
  Vec3 mean_flow = Vec3::Zero();  ///< time average over the period
  std::array<double, 2> arm_amplitudes{};  ///< d1, d2 of (4.1) [length]
  std::array<double, 2> arm_phases{};      ///< delta1, delta2 of (4.1), in (-pi, pi]
  std::array<double, 2> arm_means{};       ///< mean arm lengths [length]

  static void visit_fields(auto&& visit, auto& cycle) {
    visit("index", cycle.index, not_a_column);
    visit("velocity", cycle.velocity);
    visit("axis", cycle.axis);
    visit("speed_along_axis", cycle.speed_along_axis, not_a_column);
    visit("mean_flow", cycle.mean_flow);
    visit("arm_amplitudes", cycle.arm_amplitudes);
    visit("arm_phases", cycle.arm_phases);
    visit("arm_means", cycle.arm_means);
  }
};

/// Statistics of the cycle whose samples are given: in order of time, the first and the last exactly one
/// period apart, at least 4. Time averages are trapezoids over both ends; the stroke is fitted without the
/// last sample, so that the rest tile the period. Throws InputError if the samples are not such a cycle.
CycleStatistics cycle_statistics(int index, std::span<const SwimmerSample> samples, double period);

}  // namespace beadswim
