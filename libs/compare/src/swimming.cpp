#include "beadswim/compare/swimming.hpp"

#include <cmath>
#include <numbers>

namespace beadswim {
namespace {

Vec3 relative_velocity(const CycleStatistics& cycle, const std::optional<Box>& box) {
  Vec3 relative = cycle.velocity;
  for (int axis = 0; axis < 3 && box; ++axis) {
    if (box->is_periodic(axis)) relative[axis] -= cycle.mean_flow[axis];
  }
  return relative;
}

}  // namespace

std::size_t compared_count(ComparedQuantity quantity, const std::vector<double>& values) {
  return quantity == ComparedQuantity::arm_amplitudes ? values.size() : 1;
}

std::vector<double> with_vector(double number, const Vec3& vector) {
  return {number, vector[0], vector[1], vector[2]};
}

std::optional<Vec3> vector_of(ComparedQuantity quantity, const std::vector<double>& values) {
  if (quantity == ComparedQuantity::arm_amplitudes || values.size() != 4) return std::nullopt;
  return Vec3(values[1], values[2], values[3]);
}

double MotionScale::size_of(ComparedQuantity quantity, double bead_speed) const {
  if (quantity == ComparedQuantity::arm_amplitudes) return bead_speed * period / (2 * std::numbers::pi);
  if (quantity == ComparedQuantity::angular_velocity) return length > 0 ? bead_speed / length : 0;
  return quantity == ComparedQuantity::velocity ? bead_speed : 1;
}

double velocity_relative_to_fluid(const CycleStatistics& cycle, const std::optional<Box>& box) {
  return relative_velocity(cycle, box).dot(cycle.axis);
}

ComparedValues evaluate_compared_values(const CycleStatistics& cycle, const std::optional<Box>& box) {
  ComparedValues values{{ComparedQuantity::velocity,
                         with_vector(velocity_relative_to_fluid(cycle, box), relative_velocity(cycle, box))},
                        {ComparedQuantity::arm_amplitudes, cycle.arm_amplitudes}};
  if (cycle.arm_phases.size() >= 2)
    values[ComparedQuantity::sin_phase_shift] = {std::sin(cycle.arm_phases[0] - cycle.arm_phases[1])};
  if (cycle.angular_velocity)
    values[ComparedQuantity::angular_velocity] =
        with_vector(cycle.angular_velocity->norm(), *cycle.angular_velocity);
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
