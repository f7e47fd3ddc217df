#include "beadswim/theory/perturbation.hpp"

#include <Eigen/LU>

#include "beadswim/theory/linear_response.hpp"

namespace beadswim {

namespace {

/// <dmu f> = 1/2 Re sum_i (d mu / d L_i) conj(x_i) f: bead velocities [length/time].
Eigen::Vector3d mean_drift(const LinearResponse& response, const std::array<Eigen::Matrix3d, 2>& slope) {
  Eigen::Vector3d drift = Eigen::Vector3d::Zero();
  for (int arm = 0; arm < 2; ++arm) {
    drift += 0.5 * slope[arm] * (std::conj(response.arm[arm]) * response.force).real();
  }
  return drift;
}

/// w: forces on the beads of a rigid swimmer, over their sum.
Eigen::Vector3d rigid_force_distribution(const Eigen::Matrix3d& mobility) {
  const Eigen::Vector3d force = mobility.inverse() * Eigen::Vector3d::Ones();
  return force / force.sum();
}

}  // namespace

SecondOrderMotion second_order_motion(const CollinearSwimmer& swimmer, const CollinearMobility& mobility) {
  const LinearResponse response = linear_response(swimmer, mobility.value);
  const Eigen::Vector3d drift = mean_drift(response, mobility.slope);
  const Eigen::Matrix<double, 2, 3> rates = arm_rates();
  const Eigen::Matrix2d arm_mobility = rates * mobility.value * rates.transpose();
  const Eigen::Vector2d mean_tension = arm_mobility.inverse() * (rates * drift);

  SecondOrderMotion motion;
  motion.velocity = rigid_force_distribution(mobility.value).dot(drift);
  motion.arm_changes = {mean_tension[0] / swimmer.stiffness[0], mean_tension[1] / swimmer.stiffness[1]};
  motion.stroke = stroke_of({response.arm[0], response.arm[1]});
  return motion;
}

}  // namespace beadswim
