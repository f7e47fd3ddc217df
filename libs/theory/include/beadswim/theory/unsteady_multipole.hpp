#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>

#include "beadswim/theory/collinear_swimmer.hpp"
#include "beadswim/theory/linear_response.hpp"
#include "beadswim/theory/mean_forces.hpp"

// Exact motion of a swimmer with inertia of fluid and beads in unbounded fluid, to second order in the
// amplitude, by multipole expansion (oscillating_spheres.hpp, mean_forces.hpp).
//
//   first order    U = M F,   M = (Z + i omega m)^-1
//   second order   V = sum_k f_k / sum_jk R_jk,   because the mean forces f_k - sum_j R_kj V sum to zero
//   arms           k_1 m_1 = R_1 V - f_1,   k_2 m_2 = f_3 - R_3 V,   R_k = sum_j R_kj
//
//   U, F  velocities of the beads; forces of driving, springs and dashpots  [length/time, mass length/time^2]
//   Z, R  resistance of oscillating flow, of steady flow [mass/time];  m  masses of the beads [mass]
//   V     mean velocity of the swimmer [length/time]
//   f_k   mean force of the fluid on bead k at V = 0 [mass length/time^2]
//   k_i   stiffness of arm i [mass/time^2];  m_i  mean change of the length of arm i [length]
//
// Page: docs/method/unsteady-multipole.md.

namespace beadswim {

/// Numbers of multipoles and of quadrature nodes (per panel and direction), which determine the numerical
/// error.
struct MultipoleResolution {
  int order, nodes;
};

/// Flow of a swimmer at rest length to second order in the velocities of its beads.
struct UnsteadyMultipoles {
  Eigen::Matrix3cd mobility;          ///< M [time/mass]
  Eigen::Matrix3cd induced_mobility;  ///< bead velocities per induced force (inertial_motion.hpp) [time/mass]
  MeanForces mean_forces;
};

/// Mean velocity and mean changes of the arm lengths, to second order in the amplitude.
struct MeanMotion {
  double by_drift = 0;                  ///< contribution of the Lagrangian drift to V [length/time]
  double by_reynolds_stress = 0;        ///< contribution of the Reynolds stress to V [length/time]
  std::array<double, 2> arm_changes{};  ///< m_i: mean length of arm i minus rest length [length]
  /// R^-1 f: mean velocities that the beads would have without mean forces [length/time].
  Eigen::Vector3d bead_velocities = Eigen::Vector3d::Zero();

  double velocity() const { return by_drift + by_reynolds_stress; }
};

/// Motion of the driven swimmer in unbounded fluid, exact to second order in the amplitude.
struct ExactMotion {
  LinearResponse response;
  MeanMotion mean;
};

/// Returns the resolution at which the relative error of V is about 1e-8 or less for l >= 2.5 lambda; nullopt
/// if the beads are so close that more than 100 multipoles per sphere are necessary.
std::optional<MultipoleResolution> sufficient_resolution(const CollinearSwimmer& swimmer);

/// Returns a coarser resolution. The change of a result from the coarser to the finer resolution is an upper
/// bound of its numerical error.
MultipoleResolution coarser(const MultipoleResolution& resolution);

/// Solves for the flow. `fluid_density` [mass/length^3] must be positive.
UnsteadyMultipoles unsteady_multipoles(const CollinearSwimmer& swimmer, double fluid_density,
                                       const MultipoleResolution& resolution);

/// Returns the mean motion of beads that oscillate with the complex velocities i omega `displacement` in the
/// flow that beads with the complex velocities `flow_velocity` cause. The two velocities are equal in
/// unbounded fluid.
MeanMotion mean_motion(const UnsteadyMultipoles& flow, const CollinearSwimmer& swimmer,
                       const Eigen::Vector3cd& displacement, const Eigen::Vector3cd& flow_velocity);

/// Returns the mean motion for the linear response `response` in unbounded fluid to any driving with the
/// frequency of `swimmer`.
MeanMotion mean_motion(const UnsteadyMultipoles& flow, const CollinearSwimmer& swimmer,
                       const LinearResponse& response);

/// Returns the motion under the driving of `swimmer`.
ExactMotion exact_motion(const UnsteadyMultipoles& flow, const CollinearSwimmer& swimmer);

}  // namespace beadswim
