#pragma once

#include <array>
#include <map>
#include <span>

#include "beadswim/swimmers/swimmer_shape.hpp"
#include "beadswim/swimmers/swimmer_type.hpp"

// Forces inside one swimmer: bonds, equation (2.2) of the paper (Pickl et al. 2017), angular springs and
// drives. All functions are pure. Bead positions are unwrapped. The forces of bonds, angles and tensions are
// free of total force and torque to roundoff. See docs/method/springs.md and driving.md.

namespace beadswim {

/// Returns the sum A_i sin(n_i (w t + phi) + phase_i) of the harmonics of a drive at `time`.
double value_of(std::span<const Harmonic> harmonics, const Driving& driving, double time);

/// Returns the rate of change of value_of() [1/time].
double rate_of(std::span<const Harmonic> harmonics, const Driving& driving, double time);

/// Returns the sum of |A_i|, an upper bound of |value_of()| at all times.
double sum_of_amplitudes(std::span<const Harmonic> harmonics);

/// Return the rest length of a bond and the rest angle of an angular spring, with their drives, at `time`.
double rest_length(const SwimmerType& type, std::size_t bond, double time);
double rest_angle(const SwimmerType& type, std::size_t angle, double time);

/// Returns the forces of the springs and of the dashpots parallel to them, equation (2.2) of the paper. The
/// tension of a bond of length L is k (L - l) + c dL/dt, with stiffness k, rest length l (with its drives)
/// and damping c.
BeadVectors bond_forces(const SwimmerType& type, double time, const BeadVectors& position,
                        const BeadVectors& velocity);

/// Sides of an angular spring, from its first bead to the second and from the second to the third: unit
/// vectors along them, their lengths, and cosine and sine of the angle between them.
struct AngleSides {
  std::array<Vec3, 2> direction;
  std::array<double, 2> length;  ///< [length]
  double cosine, sine;
};
AngleSides sides_of(const Angle& angle, const BeadVectors& position);

/// Returns the forces -grad U of the angular springs for the bending energies U (Angle). Where the three
/// beads of an angle are in line, the force of a rest angle other than 0 or pi has no direction and is set to
/// 0.
BeadVectors angle_forces(const SwimmerType& type, double time, const BeadVectors& position);

/// Returns the sums of the driving forces that are not zero within roundoff: their sizes [force], by the
/// multiple of the frequency; 0 for constant forces.
std::map<int, double> net_forces(const Driving& driving);

/// Returns an upper bound of the force that the drives of forces and bonds exert on a bead: the largest sum
/// of the amplitudes on one bead, for rest lengths times the stiffness.
double largest_driving_force(const SwimmerType& type);

/// Returns the driving forces, equation (2.1) of the paper for three beads, and those of driven tensions.
/// initial_orientation: orientation of the swimmer at the start of the run.
BeadVectors driving_forces(const SwimmerType& type, double time, const BeadVectors& position,
                           const Eigen::Matrix3d& initial_orientation);

/// Returns the power of the drives at `time` [mass length^2/time^3]: the work of forces and tensions on the
/// beads, and of driven rest lengths and rest angles on their springs. That of hinges neglects the change of
/// n by the drives, which is of second order in the strain s (hinges.hpp). Arguments as of driving_forces();
/// velocity: of the beads.
double power_of_drives(const SwimmerType& type, double time, const BeadVectors& position,
                       const BeadVectors& velocity, const Eigen::Matrix3d& initial_orientation);

}  // namespace beadswim
