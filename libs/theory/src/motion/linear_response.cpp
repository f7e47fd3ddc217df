#include "beadswim/theory/linear_response.hpp"

#include <Eigen/LU>

#include "beadswim/core/complex.hpp"

namespace beadswim {

namespace {

/// Returns k_i + i omega c_i for both arms (stiffness k_i, damping c_i): complex tension of spring and
/// dashpot per change of the arm length [mass/time^2].
Eigen::Vector2cd arm_stiffness(const CollinearSwimmer& swimmer) {
  const double omega = swimmer.angular_frequency();
  return {swimmer.stiffness[0] + i_unit * omega * swimmer.damping[0],
          swimmer.stiffness[1] + i_unit * omega * swimmer.damping[1]};
}

}  // namespace

Eigen::Matrix<double, 2, 3> arm_rates() {
  Eigen::Matrix<double, 2, 3> rates;
  // clang-format off
  rates << -1,  1,  0,
            0, -1,  1;
  // clang-format on
  return rates;
}

Eigen::Vector2cd driving_tensions(const CollinearSwimmer& swimmer) {
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

LinearResponse response_to_stroke(const Eigen::Vector2cd& arm, const Eigen::Matrix3cd& mobility,
                                  double angular_frequency) {
  const Eigen::Vector3cd force_per_frequency =
      arm_rates().cast<Complex>().transpose() * (arm_impedance(mobility) * arm);
  return {.arm = arm,
          .displacement = mobility * force_per_frequency,
          .force = i_unit * angular_frequency * force_per_frequency};
}

Eigen::Matrix2cd arm_impedance(const Eigen::Matrix3cd& mobility) {
  const Eigen::Matrix<Complex, 2, 3> rates = arm_rates().cast<Complex>();
  return (rates * mobility * rates.transpose()).inverse();
}

Eigen::Vector2cd driven_arms(const CollinearSwimmer& swimmer, const Eigen::Matrix2cd& impedance) {
  Eigen::Matrix2cd stiffness = i_unit * swimmer.angular_frequency() * impedance;
  stiffness.diagonal() += arm_stiffness(swimmer);
  return stiffness.inverse() * driving_tensions(swimmer);
}

LinearResponse linear_response(const CollinearSwimmer& swimmer, const Eigen::Matrix3cd& mobility) {
  const Eigen::Vector2cd arm = driven_arms(swimmer, arm_impedance(mobility));
  return response_to_stroke(arm, mobility, swimmer.angular_frequency());
}

LinearResponse linear_response(const CollinearSwimmer& swimmer, const Eigen::Matrix3d& mobility) {
  return linear_response(swimmer, Eigen::Matrix3cd(mobility.cast<Complex>()));
}

Stroke first_order_stroke(const CollinearSwimmer& swimmer, PairLaw law) {
  const LinearResponse response = linear_response(swimmer, rest_mobility(swimmer, law).value);
  return stroke_of({response.arm[0], response.arm[1]});
}

}  // namespace beadswim
