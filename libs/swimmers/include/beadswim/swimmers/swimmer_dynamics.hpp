#pragma once

#include <array>

#include "beadswim/core/vec3.hpp"
#include "beadswim/swimmers/swimmer_forces.hpp"
#include "beadswim/swimmers/swimmer_type.hpp"

// Newton's equations of the three beads of one swimmer, in any coherent unit system.

namespace beadswim {

/// Motion of a sphere; its orientation has no effect on anything and is not kept.
struct BeadMotion {
  Vec3 position = Vec3::Zero();  ///< unwrapped
  Vec3 velocity = Vec3::Zero();
  Vec3 angular_velocity = Vec3::Zero();

  static void visit_fields(auto&& visit, auto& bead) {
    visit("position", bead.position);
    visit("velocity", bead.velocity);
    visit("angular_velocity", bead.angular_velocity);
  }
};

/// Force and torque about the centre.
struct Load {
  Vec3 force = Vec3::Zero();
  Vec3 torque = Vec3::Zero();

  static void visit_fields(auto&& visit, auto& load) {
    visit("force", load.force);
    visit("torque", load.torque);
  }
};

using SwimmerMotion = std::array<BeadMotion, 3>;
using SwimmerLoads = std::array<Load, 3>;

double mass(const Bead& bead);               ///< 4/3 pi R^3 rho
double moment_of_inertia(const Bead& bead);  ///< 2/5 m R^2

/// Sub-steps that resolve the swimmer's fastest vibration (of springs, dashpots and angular spring, with the
/// arms at rest length) within `step`: |eigenvalue| x sub-step <= 1/4, a tenth of what the integrator bears.
/// Throws InputError if that takes more than 10000.
int substeps_for(const SwimmerType& type, double step);

/// The type for steps in which loads are constant: vibrations that such a step does not resolve would be
/// driven by loads that answer to them a step late.
/// - Springs with omega step > 1/2, omega^2 = 3/2 k (1/m + 1/m') (of both arms together), get a dashpot of at
///   least k step/2, half of critical at most. Slower motion at w lags by w step/2 at most in the spring.
/// - An angular spring with omega step > 3/4, omega that of bending, is softened to that: under a load that
///   would accelerate the beads by a the swimmer bends by some 2 a step^2, more than the stiffer one lets it.
///   (A dashpot of inner forces alone cannot damp bending that goes round the axis.)
SwimmerType with_steady_vibrations(SwimmerType type, double step);

/// Advances the beads from `time` to `time + step` under their inner and driving forces, and `loads` held
/// constant meanwhile. Classical Runge-Kutta: error O(sub-step^4).
void advance_swimmer(SwimmerMotion& motion, const SwimmerType& type, const Vec3& initial_axis,
                     const SwimmerLoads& loads, double time, double step, int substeps);

}  // namespace beadswim
