#include "beadswim/swimmers/swimmer_forces.hpp"

#include <cmath>
#include <numbers>

namespace beadswim {

BeadVectors spring_forces(const std::array<Spring, 2>& springs, const BeadVectors& position,
                          const BeadVectors& velocity) {
  BeadVectors force{Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
  for (int arm = 0; arm < 2; ++arm) {
    const Spring& spring = springs[arm];
    const Vec3 separation = position[arm + 1] - position[arm];
    const double length = separation.norm();
    const Vec3 direction = separation / length;
    const double rate = direction.dot(velocity[arm + 1] - velocity[arm]);
    const double tension = spring.stiffness * (length - spring.rest_length) + spring.damping * rate;
    force[arm] += tension * direction;
    force[arm + 1] -= tension * direction;
  }
  return force;
}

BeadVectors angular_spring_forces(double angular_stiffness, const BeadVectors& position) {
  const Vec3 arm_1 = position[1] - position[0];
  const Vec3 arm_2 = position[2] - position[1];
  const double length_1 = arm_1.norm();
  const double length_2 = arm_2.norm();
  const Vec3 direction_1 = arm_1 / length_1;
  const Vec3 direction_2 = arm_2 / length_2;
  const double cosine = direction_1.dot(direction_2);
  const double sine = direction_1.cross(direction_2).norm();
  // theta/sin(theta) is 1 for parallel arms. For antiparallel arms the force has no defined direction and is
  // set to 0.
  constexpr double smallest_sine = 1e-12;
  const double theta_over_sine =
      sine > smallest_sine ? std::atan2(sine, cosine) / sine : (cosine > 0 ? 1 : 0);
  // Gradients of the bending energy U = K_A theta^2/2 with respect to arm_1 and arm_2.
  const Vec3 gradient_1 =
      -angular_stiffness * theta_over_sine / length_1 * (direction_2 - cosine * direction_1);
  const Vec3 gradient_2 =
      -angular_stiffness * theta_over_sine / length_2 * (direction_1 - cosine * direction_2);
  return {gradient_1, gradient_2 - gradient_1, -gradient_2};
}

BeadVectors driving_forces(const Driving& driving, double time, const BeadVectors& position,
                           const Vec3& initial_axis) {
  const double omega_t = 2 * std::numbers::pi * (time / driving.period) + driving.phase_offset;
  const double force_1 = driving.amplitude[0] * std::sin(omega_t);
  const double force_3 = driving.amplitude[1] * std::sin(omega_t + driving.phase);

  if (driving.frame == DrivingFrame::body) {
    const Vec3 along_1 = force_1 * (position[1] - position[0]).normalized();
    const Vec3 along_2 = force_3 * (position[2] - position[1]).normalized();
    return {along_1, -along_1 - along_2, along_2};
  }
  const Vec3 direction = driving.frame == DrivingFrame::lab ? Vec3::UnitX() : initial_axis;
  return {force_1 * direction, -(force_1 + force_3) * direction, force_3 * direction};
}

}  // namespace beadswim
