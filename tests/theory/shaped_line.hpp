#pragma once

#include <Eigen/Geometry>

#include "beadswim/swimmers/three_bead_swimmer.hpp"
#include "beadswim/theory/shaped_swimmer.hpp"
#include "swimmers.hpp"

namespace beadswim {

/// Returns three beads on a line as a swimmer of any shape, turned by `orientation`.
inline ShapedSwimmer shaped(const CollinearSwimmer& line, const Eigen::Matrix3d& orientation) {
  ThreeBeadSwimmer three;
  for (int b = 0; b < 3; ++b) three.beads[b] = {line.radius[b], 1};
  for (int k = 0; k < 2; ++k) three.springs[k] = {line.stiffness[k], line.arm[k], line.damping[k]};
  three.angular_stiffness = 10 * line.stiffness[0] * line.arm[0] * line.arm[0];
  three.driving = {.amplitude = line.amplitude,
                   .phase = line.phase,
                   .period = line.period,
                   .frame = DrivingFrame::initial_axis};
  return {swimmer_type(three), orientation, line.viscosity};
}

inline Eigen::Matrix3d some_orientation() {
  return Eigen::AngleAxisd(2, Vec3(2, -1, 2) / 3).toRotationMatrix();
}

}  // namespace beadswim
