#include "beadswim/compare/driving_power.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include "beadswim/compare/stroke_fit.hpp"

namespace beadswim {

double driving_power(const Driving& driving, const Vec3& initial_axis,
                     std::span<const SwimmerSample> samples) {
  const double omega = 2 * std::numbers::pi / driving.period;
  const Vec3 direction = driving.frame == DrivingFrame::lab ? Vec3::UnitX() : initial_axis;
  const std::array<double, 2> force_phase{driving.phase_offset, driving.phase_offset + driving.phase};
  double power = 0;
  for (std::size_t arm = 0; arm < 2; ++arm) {
    std::vector<double> times, lengths;
    for (const SwimmerSample& sample : samples.first(samples.size() - 1)) {
      const Vec3 from_to = sample.bead_positions[arm + 1] - sample.bead_positions[arm];
      times.push_back(sample.time);
      lengths.push_back(driving.frame == DrivingFrame::body ? from_to.norm() : direction.dot(from_to));
    }
    const StrokeFit fit = fit_stroke(times, lengths, omega);
    const double work = driving.amplitude[arm] * fit.amplitude * std::cos(fit.phase - force_phase[arm]);
    power += omega / 2 * (arm == 0 ? work : -work);
  }
  return power;
}

}  // namespace beadswim
