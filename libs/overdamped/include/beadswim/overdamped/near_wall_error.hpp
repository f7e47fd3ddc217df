#pragma once

#include "beadswim/overdamped/overdamped_setup.hpp"

namespace beadswim {

/// Returns the relative error of the mobility of one sphere over a plane no-slip wall, at this height over
/// its radius: across the wall, where it is largest, and along it with rpy+near.
double error_near_wall(double height, MobilityModel model, const MobilitySettings& settings);

}  // namespace beadswim
