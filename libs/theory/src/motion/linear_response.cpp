#include "beadswim/theory/linear_response.hpp"

#include <algorithm>

#include "beadswim/core/complex.hpp"
#include "beadswim/core/dense_systems.hpp"

namespace beadswim {

namespace {

/// Returns Z = (D mu D^T)^-1 [mass/time]. `deformations`: D.
Eigen::MatrixXcd impedance(const Eigen::MatrixXd& deformations, const Eigen::MatrixXcd& mobility) {
  const Eigen::MatrixXcd mobility_of_deformations = deformations * mobility * deformations.transpose();
  return inverse(mobility_of_deformations);
}

/// Returns the mean bead velocities <dmu f> [length/time]. `slope`: d mu / d x_k.
Eigen::Vector3d mean_drift(const LinearResponse& response, const std::array<Eigen::Matrix3d, 3>& slope) {
  Eigen::Vector3d drift = Eigen::Vector3d::Zero();
  for (int k = 0; k < 3; ++k) {
    drift += 0.5 * slope[k] * (std::conj(response.displacement[k]) * response.force).real();
  }
  return drift;
}

}  // namespace

LinearResponse linear_response(const SpringNetwork& springs, const Eigen::MatrixXcd& mobility,
                               const Eigen::VectorXcd& tension, double angular_frequency) {
  const Complex i_omega = i_unit * angular_frequency;
  const Eigen::MatrixXcd resistance =
      i_omega * impedance(springs.deformations, mobility) + springs.stiffness + i_omega * springs.damping;
  return response_to_stroke(springs.deformations, solve(resistance, tension), mobility, angular_frequency);
}

LinearResponse response_to_stroke(const Eigen::MatrixXd& deformations, const Eigen::VectorXcd& arm,
                                  const Eigen::MatrixXcd& mobility, double angular_frequency) {
  const Eigen::VectorXcd force_per_frequency =
      deformations.transpose() * (impedance(deformations, mobility) * arm);
  return {.arm = arm,
          .displacement = mobility * force_per_frequency,
          .force = i_unit * angular_frequency * force_per_frequency};
}

Eigen::MatrixXd towing_forces(const Eigen::MatrixXd& mobility, const Eigen::MatrixXd& free_motions) {
  const Eigen::MatrixXd forces = solve(mobility, free_motions);
  const Eigen::MatrixXd drag = free_motions.transpose() * forces;
  return forces * inverse(drag);
}

Eigen::VectorXd towing_forces(const Eigen::MatrixXd& mobility) {
  const Eigen::VectorXd ones = Eigen::VectorXd::Ones(mobility.rows()), forces = solve(mobility, ones);
  return forces / forces.sum();
}

MeanBalance balance_mean(const SpringNetwork& springs, const Eigen::MatrixXd& mobility,
                         const Eigen::VectorXd& drift) {
  const Eigen::MatrixXd& D = springs.deformations;
  const Eigen::MatrixXd mobility_of_deformations = D * mobility * D.transpose();
  const Eigen::VectorXd rates = D * drift, tension = solve(mobility_of_deformations, rates);
  return {.free_rates = towing_forces(mobility, springs.free_motions).transpose() * drift,
          .deformation = solve(springs.stiffness, tension)};
}

Eigen::Matrix<double, 2, 3> arm_rates() {
  Eigen::Matrix<double, 2, 3> rates;
  // clang-format off
  rates << -1,  1,  0,
            0, -1,  1;
  // clang-format on
  return rates;
}

SpringNetwork springs_of(const CollinearSwimmer& swimmer) {
  const auto diagonal = [](const std::array<double, 2>& values) -> Eigen::MatrixXd {
    return Eigen::Vector2d(values[0], values[1]).asDiagonal();
  };
  return {.deformations = arm_rates(),
          .free_motions = Eigen::Vector3d::Ones(),
          .stiffness = diagonal(swimmer.stiffness),
          .damping = diagonal(swimmer.damping)};
}

Eigen::Vector2cd driving_tensions(const CollinearSwimmer& swimmer) {
  // The driving forces are sines: A sin(omega t) = Re(-iA exp(i omega t)).
  const Complex force_1 = -i_unit * swimmer.amplitude[0];
  const Complex force_3 = -i_unit * swimmer.amplitude[1] * std::polar(1.0, swimmer.phase);
  return {-force_1, force_3};
}

double mean_power(const CollinearSwimmer& swimmer, const Stroke& stroke) {
  const Eigen::Vector2cd tension = driving_tensions(swimmer);
  double power = 0;
  for (int i = 0; i < 2; ++i) {
    const Complex rate =
        i_unit * swimmer.angular_frequency() * std::polar(stroke.amplitude[i], stroke.phase[i]);
    power += (tension[i] * std::conj(rate)).real() / 2;
  }
  return power;
}

double second_order_scale(const CollinearSwimmer& swimmer, const Stroke& stroke) {
  const double swing = std::max(stroke.amplitude[0], stroke.amplitude[1]);
  return swimmer.angular_frequency() * swing * swing / swimmer.arm[0];
}

LinearResponse linear_response(const CollinearSwimmer& swimmer, const Eigen::Matrix3cd& mobility) {
  return linear_response(springs_of(swimmer), mobility, driving_tensions(swimmer),
                         swimmer.angular_frequency());
}

LinearResponse linear_response(const CollinearSwimmer& swimmer, const Eigen::Matrix3d& mobility) {
  return linear_response(swimmer, Eigen::Matrix3cd(mobility.cast<Complex>()));
}

Stroke first_order_stroke(const CollinearSwimmer& swimmer, PairLaw law) {
  return stroke_of(linear_response(swimmer, rest_mobility(swimmer, law).value).arm);
}

// Mean dipole to second order: < sum_i (x_i + sigma_i) F_i >. The mean forces are -D^T K m.
PeriodicMotion second_order_motion(const CollinearSwimmer& swimmer, const CollinearMobility& mobility) {
  const LinearResponse response = linear_response(swimmer, mobility.value);
  const SpringNetwork springs = springs_of(swimmer);
  const MeanBalance mean = balance_mean(springs, mobility.value, mean_drift(response, mobility.slope));
  const Eigen::VectorXcd lever = response.displacement + mobility.stresslet_slope * response.displacement;
  const Eigen::Vector2d arms(swimmer.arm[0], swimmer.arm[1]);
  const Eigen::Vector2d mean_tension = springs.stiffness * mean.deformation;
  const double dipole =
      0.5 * lever.dot(response.force).real() - mean_tension.dot(arms + arm_rates() * mobility.stresslet);
  return {.velocity = mean.free_rates[0],
          .stroke = stroke_of(response.arm),
          .arm_changes = {mean.deformation[0], mean.deformation[1]},
          .dipole = dipole_of_line(dipole)};
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
