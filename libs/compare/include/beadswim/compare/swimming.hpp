#pragma once

#include <optional>

#include "beadswim/compare/cycle_statistics.hpp"
#include "beadswim/compare/result_quantity.hpp"
#include "beadswim/core/box.hpp"

// Frame of reference of velocities, and scales of the motion of a swimmer.

namespace beadswim {

/// Scales of a swimmer's motion, to which the errors of quantities that should be zero are relative.
struct MotionScale {
  double period = 1;           ///< [time]
  double length = 0;           ///< longest mean arm, or radius of the largest bead [length]
  double speed = 0;            ///< largest speed of a bead [length/time]
  double numerical_error = 0;  ///< error of velocities; 0 if none is stated [length/time]

  /// Returns the scale of a quantity for beads of this speed: their displacement in one radian of the drives
  /// for lengths, bead_speed/length for angular velocities, 1 for angles and sines, 0 (none) for others.
  double size_of(ResultQuantity quantity, double bead_speed) const;
};

/// Returns the swimmer's velocity relative to the fluid [length/time]. The mean flow is subtracted along
/// periodic axes only: along other axes the walls define the frame of reference.
Vec3 vector_relative_to_fluid(const CycleStatistics& cycle, const std::optional<Box>& box);

/// Returns the component of vector_relative_to_fluid() along the swimmer's axis [length/time].
double velocity_relative_to_fluid(const CycleStatistics& cycle, const std::optional<Box>& box);

}  // namespace beadswim
