#include "beadswim/compare/swimming.hpp"

#include <cmath>

namespace beadswim {

double velocity_relative_to_fluid(const CycleStatistics& cycle, const std::optional<Box>& box) {
  Vec3 relative = cycle.velocity;
  for (int axis = 0; axis < 3 && box; ++axis) {
    if (box->is_periodic(axis)) relative[axis] -= cycle.mean_flow[axis];
  }
  return relative.dot(cycle.axis);
}

ComparedValues evaluate_compared_values(const CycleStatistics& cycle, const std::optional<Box>& box) {
  ComparedValues values{{ComparedQuantity::velocity, {velocity_relative_to_fluid(cycle, box)}},
                        {ComparedQuantity::arm_amplitudes, cycle.arm_amplitudes}};
  if (cycle.arm_phases.size() >= 2)
    values[ComparedQuantity::sin_phase_shift] = {std::sin(cycle.arm_phases[0] - cycle.arm_phases[1])};
  if (cycle.angular_velocity) values[ComparedQuantity::angular_velocity] = {cycle.angular_velocity->norm()};
  return values;
}

ComparedValues average_compared_values(std::span<const ComparedValues> cycles) {
  ComparedValues mean = cycles.front();
  for (auto& [quantity, values] : mean) {
    for (std::size_t i = 0; i < values.size(); ++i) {
      double sum = 0;
      for (const ComparedValues& cycle : cycles) sum += cycle.at(quantity)[i];
      values[i] = sum / static_cast<double>(cycles.size());
    }
  }
  return mean;
}

}  // namespace beadswim
