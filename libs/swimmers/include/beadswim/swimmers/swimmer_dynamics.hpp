#pragma once

#include <span>
#include <vector>

#include "beadswim/core/fields.hpp"
#include "beadswim/core/vec3.hpp"
#include "beadswim/swimmers/swimmer_forces.hpp"
#include "beadswim/swimmers/swimmer_type.hpp"

// Newton's equations of motion for the beads of one swimmer, in any coherent unit system.

namespace beadswim {

/// Motion of a spherical bead. Its orientation is not stored, because nothing depends on it.
struct BeadMotion {
  Vec3 position = Vec3::Zero();  ///< unwrapped position of the centre [length]
  Vec3 velocity = Vec3::Zero();
  Vec3 angular_velocity = Vec3::Zero();

  BEADSWIM_FIELDS(position, velocity, angular_velocity)
};

/// Force on a bead [mass length/time^2], and torque about its centre [mass length^2/time^2].
struct Load {
  Vec3 force = Vec3::Zero();
  Vec3 torque = Vec3::Zero();

  BEADSWIM_FIELDS(force, torque)
};

using SwimmerMotion = std::vector<BeadMotion>;  ///< one per bead
using SwimmerLoads = std::vector<Load>;         ///< one per bead

double mass(const Bead& bead);               ///< returns 4/3 pi R^3 rho, R: radius, rho: density [mass]
double moment_of_inertia(const Bead& bead);  ///< returns 2/5 m R^2, m: mass, R: radius [mass length^2]

/// Returns the number of substeps of `step` that resolve the fastest vibration of the swimmer with bonds at
/// rest length. The substep is so short that the largest |eigenvalue| of the equations of motion [1/time],
/// with springs, dashpots and angular spring, times the substep is at most 1/4. This is about a tenth of the
/// stability limit of the integrator. Throws InputError if more than 10000 substeps are needed.
int substeps_for(const SwimmerType& type, double step);

/// Returns a copy of the type in which vibrations that the time step does not resolve are damped or slowed
/// down. Reason: the loads (forces of the fluid) are constant during a step and respond to a vibration one
/// step late. They would amplify an unresolved vibration.
/// - A spring with omega step > 1/2 gets a dashpot of at least k step/2, but at most half of the critical
///   damping. Here omega^2 = n k (1/m + 1/m'), k is the stiffness, m and m' are the masses of the two beads,
///   and n is the mean number of bonds of these beads: 3/2 for three beads in a line. The factor n accounts
///   for the vibration of adjacent bonds together. In a slower motion at angular frequency w, the dashpot
///   delays the length of the spring by a phase of at most w step/2.
/// - An angular spring with omega step > 3/4, where omega is the angular frequency of bending, is softened
///   until omega step = 3/4. Under a load that would accelerate the beads by a, the swimmer then bends by a
///   displacement of about 2 a step^2, which is more than with the original angular spring. Damping cannot
///   replace this softening: a dashpot between the beads cannot damp a bending direction that rotates about
///   the axis.
SwimmerType with_resolved_vibrations(SwimmerType type, double step);

/// Advances the beads from `time` to `time + step` under internal forces, driving forces and `loads`. The
/// loads, one per bead, are constant during the step. initial_orientation: orientation of the swimmer at the
/// start of the run. Uses the classical Runge-Kutta method with `substeps` substeps. The error is
/// O(substep^4).
void advance_swimmer(std::span<BeadMotion> motion, const SwimmerType& type,
                     const Eigen::Matrix3d& initial_orientation, std::span<const Load> loads, double time,
                     double step, int substeps);

}  // namespace beadswim
