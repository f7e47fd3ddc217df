#include "beadswim/theory/perturbation.hpp"

#include <Eigen/LU>

#include "beadswim/theory/linear_response.hpp"

namespace beadswim {

namespace {

/// Returns the mean bead velocities <dmu f> = 1/2 Re sum_k (d mu / d x_k) conj(xi_k) f [length/time]. xi_k
/// are the displacements of the beads, f the forces on the beads, mu is the mobility.
Eigen::Vector3d mean_drift(const LinearResponse& response, const std::array<Eigen::Matrix3d, 3>& slope) {
  Eigen::Vector3d drift = Eigen::Vector3d::Zero();
  for (int k = 0; k < 3; ++k) {
    drift += 0.5 * slope[k] * (std::conj(response.displacement[k]) * response.force).real();
  }
  return drift;
}

}  // namespace

Eigen::Vector3d rigid_force_distribution(const Eigen::Matrix3d& mobility) {
  const Eigen::Vector3d force = mobility.partialPivLu().solve(Eigen::Vector3d::Ones());
  return force / force.sum();
}

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

double velocity_of_stroke(const Eigen::Vector2cd& arm, const CollinearMobility& mobility,
                          double angular_frequency) {
  const LinearResponse response =
      response_to_stroke(arm, mobility.value.cast<std::complex<double>>(), angular_frequency);
  return rigid_force_distribution(mobility.value).dot(mean_drift(response, mobility.slope));
}

double geometry_factor(const CollinearMobility& mobility) {
  // A stroke of unit area: d_1 = d_2 = 1, delta_1 - delta_2 = pi/2.
  return velocity_of_stroke({std::complex<double>(0, 1), 1}, mobility, 1);
}

}  // namespace beadswim
