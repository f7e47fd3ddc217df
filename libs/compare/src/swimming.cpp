#include "beadswim/compare/swimming.hpp"

#include <numbers>

namespace beadswim {

double MotionScale::size_of(ResultQuantity quantity, double bead_speed) const {
  switch (row_of(quantity).dimension) {
    case Dimension::velocity:
      return bead_speed;
    case Dimension::length:
      return bead_speed * period / (2 * std::numbers::pi);
    case Dimension::angular_velocity:
      return length > 0 ? bead_speed / length : 0;
    case Dimension::angle:
      return 1;
    case Dimension::number:
    case Dimension::power:
      break;
  }
  return quantity == ResultQuantity::sin_phase_shift ? 1 : 0;
}

Vec3 vector_relative_to_fluid(const CycleStatistics& cycle, const std::optional<Box>& box) {
  Vec3 relative = cycle.velocity;
  for (int axis = 0; axis < 3 && box; ++axis) {
    if (box->is_periodic(axis)) relative[axis] -= cycle.mean_flow[axis];
  }
  return relative;
}

double velocity_relative_to_fluid(const CycleStatistics& cycle, const std::optional<Box>& box) {
  return vector_relative_to_fluid(cycle, box).dot(cycle.axis);
}

}  // namespace beadswim
