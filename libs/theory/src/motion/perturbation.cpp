#include "beadswim/theory/perturbation.hpp"

#include "beadswim/theory/linear_response.hpp"

namespace beadswim {

namespace {

/// Returns the mean bead velocities <dmu f> [length/time]. `slope`: d mu / d x_k.
Eigen::Vector3d mean_drift(const LinearResponse& response, const std::array<Eigen::Matrix3d, 3>& slope) {
  Eigen::Vector3d drift = Eigen::Vector3d::Zero();
  for (int k = 0; k < 3; ++k) {
    drift += 0.5 * slope[k] * (std::conj(response.displacement[k]) * response.force).real();
  }
  return drift;
}

}  // namespace

PeriodicMotion second_order_motion(const CollinearSwimmer& swimmer, const CollinearMobility& mobility) {
  const LinearResponse response = linear_response(swimmer, mobility.value);
  const MeanBalance mean =
      balance_mean(springs_of(swimmer), mobility.value, mean_drift(response, mobility.slope));
  return {.velocity = mean.free_rates[0],
          .stroke = stroke_of(response.arm),
          .arm_changes = {mean.deformation[0], mean.deformation[1]}};
}

double velocity_of_stroke(const Eigen::Vector2cd& arm, const CollinearMobility& mobility,
                          double angular_frequency) {
  const LinearResponse response =
      response_to_stroke(arm_rates(), arm, mobility.value.cast<std::complex<double>>(), angular_frequency);
  return towing_forces(mobility.value).dot(mean_drift(response, mobility.slope));
}

double geometry_factor(const CollinearMobility& mobility) {
  // A stroke of unit area: d_1 = d_2 = 1, delta_1 - delta_2 = pi/2.
  return velocity_of_stroke({std::complex<double>(0, 1), 1}, mobility, 1);
}

}  // namespace beadswim
