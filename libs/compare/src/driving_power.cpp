#include "beadswim/compare/driving_power.hpp"

#include <array>
#include <cmath>
#include <numbers>

namespace beadswim {

double driving_power(const ThreeBeadDriving& driving, const Vec3& initial_axis,
                     std::span<const SwimmerSample> samples) {
  const double omega = 2 * std::numbers::pi / driving.period;
  const Vec3 direction = driving.frame == DrivingFrame::lab ? Vec3::UnitX() : initial_axis;
  const std::array<double, 2> force_phase{driving.phase_offset, driving.phase_offset + driving.phase};
  double power = 0;
  for (std::size_t arm = 0; arm < 2; ++arm) {
    const StrokeFit fit = fit_cycle(samples, driving.period, [&](const SwimmerSample& sample) {
      const Vec3 vector = arm_vector(sample, arm);
      return driving.frame == DrivingFrame::body ? vector.norm() : direction.dot(vector);
    });
    const double work = driving.amplitude[arm] * fit.amplitude * std::cos(fit.phase - force_phase[arm]);
    power += omega / 2 * (arm == 0 ? work : -work);
  }
  return power;
}

}  // namespace beadswim
