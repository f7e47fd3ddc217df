#include "beadswim/theory/linear_response.hpp"

#include "beadswim/core/complex.hpp"
#include "beadswim/core/dense_systems.hpp"

namespace beadswim {

namespace {

/// Returns Z = (D mu D^T)^-1 [mass/time]. `deformations`: D.
Eigen::MatrixXcd impedance(const Eigen::MatrixXd& deformations, const Eigen::MatrixXcd& mobility) {
  const Eigen::MatrixXcd mobility_of_deformations = deformations * mobility * deformations.transpose();
  return inverse(mobility_of_deformations);
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

}  // namespace beadswim
