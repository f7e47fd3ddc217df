#pragma once

#include <array>

#include "beadswim/core/vec3.hpp"
#include "beadswim/swimmers/swimmer_forces.hpp"
#include "beadswim/swimmers/swimmer_type.hpp"

// Newton's equations of motion for the three beads of one swimmer, in any coherent unit system.

namespace beadswim {

/// Motion of a spherical bead. Its orientation is not stored, because nothing depends on it.
struct BeadMotion {
  Vec3 position = Vec3::Zero();  ///< of the centre, unwrapped [length]
  Vec3 velocity = Vec3::Zero();
  Vec3 angular_velocity = Vec3::Zero();

  static void visit_fields(auto&& visit, auto& bead) {
    visit("position", bead.position);
    visit("velocity", bead.velocity);
    visit("angular_velocity", bead.angular_velocity);
  }
};

/// Force, and torque about the centre of the bead.
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

double mass(const Bead& bead);               ///< returns 4/3 pi R^3 rho [mass]
double moment_of_inertia(const Bead& bead);  ///< returns 2/5 m R^2 [mass length^2]

/// Returns the number of substeps that resolve the fastest vibration of the swimmer (springs, dashpots and
/// angular spring, arms at rest length) within `step`. Criterion: |eigenvalue| x substep <= 1/4, a tenth of
/// the stability limit of the integrator. Throws InputError if more than 10000 substeps are needed.
int substeps_for(const SwimmerType& type, double step);

/// Returns the type with vibrations that a step of constant loads can follow. The loads respond to a
/// vibration one step late and would drive vibrations that the step does not resolve.
/// - A spring with omega step > 1/2, where omega^2 = 3/2 k (1/m + 1/m') (both arms together), gets a dashpot
///   of at least k step/2, but at most half of the critical damping. A slower motion at angular frequency w
///   lags in this spring by a phase of at most w step/2.
/// - An angular spring with omega step > 3/4, where omega is the frequency of bending, is softened to omega
///   step = 3/4. Under a load that would accelerate the beads by a, the swimmer bends by about 2 a step^2,
///   which is more than with the original spring. Damping is no alternative: a dashpot of internal forces
///   cannot damp a bending direction that rotates about the axis.
SwimmerType with_resolved_vibrations(SwimmerType type, double step);

/// Advances the beads from `time` to `time + step` under internal forces, driving forces and `loads`. The
/// loads are constant during the step. Classical Runge-Kutta method with `substeps` substeps: error
/// O(substep^4).
void advance_swimmer(SwimmerMotion& motion, const SwimmerType& type, const Vec3& initial_axis,
                     const SwimmerLoads& loads, double time, double step, int substeps);

}  // namespace beadswim
