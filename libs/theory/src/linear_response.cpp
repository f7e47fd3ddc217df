#include "beadswim/theory/linear_response.hpp"

#include <Eigen/LU>

namespace beadswim {

namespace {

using Complex = std::complex<double>;
constexpr Complex i_unit{0, 1};

/// (2.1) as complex amplitudes: A sin(omega t) = Re(-iA exp(i omega t)).
Eigen::Vector3cd driving_amplitudes(const CollinearSwimmer& swimmer) {
  const Complex force_1 = -i_unit * swimmer.amplitude[0];
  const Complex force_3 = -i_unit * swimmer.amplitude[1] * std::polar(1.0, swimmer.phase);
  return {force_1, -force_1 - force_3, force_3};
}

/// k_i + i omega c_i: tension of a spring with a dashpot beside it, per change of its arm.
Eigen::Vector2cd arm_stiffness(const CollinearSwimmer& swimmer) {
  const double omega = swimmer.angular_frequency();
  return {swimmer.stiffness[0] + i_unit * omega * swimmer.damping[0],
          swimmer.stiffness[1] + i_unit * omega * swimmer.damping[1]};
}

}  // namespace

Eigen::Matrix<double, 2, 3> arm_rates() {
  Eigen::Matrix<double, 2, 3> rates;
  rates << -1, 1, 0, 0, -1, 1;
  return rates;
}

LinearResponse linear_response(const CollinearSwimmer& swimmer, const Eigen::Matrix3d& mobility) {
  const Eigen::Matrix<double, 2, 3> rates = arm_rates();
  const Eigen::Vector3cd driving = driving_amplitudes(swimmer);
  const Eigen::Vector2cd stiffness = arm_stiffness(swimmer);

  const Eigen::Matrix2cd arm_mobility = (rates * mobility * rates.transpose()).cast<Complex>();
  Eigen::Matrix2cd response = arm_mobility * stiffness.asDiagonal();
  response.diagonal().array() += i_unit * swimmer.angular_frequency();

  LinearResponse first_order;
  first_order.arm = response.partialPivLu().solve((rates * mobility).cast<Complex>() * driving);
  const Eigen::Vector2cd tension = stiffness.cwiseProduct(first_order.arm);
  first_order.force = driving - rates.transpose().cast<Complex>() * tension;
  return first_order;
}

Stroke first_order_stroke(const CollinearSwimmer& swimmer, PairLaw law) {
  const LinearResponse response = linear_response(swimmer, rest_mobility(swimmer, law).value);
  return stroke_of({response.arm[0], response.arm[1]});
}

}  // namespace beadswim
