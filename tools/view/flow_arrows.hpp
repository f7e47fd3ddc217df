#pragma once

#include <optional>
#include <string>
#include <vector>

#include "beadswim/documents/trajectory_file.hpp"

namespace beadswim {

/// Arrows of a flow file: cells on a regular subgrid, without those that lie in beads or are hidden.
struct FlowArrows {
  double spacing = 1;                        ///< distance between neighbouring arrows along an axis [length]
  std::optional<int> mean_cycles{};          ///< cycles of a mean; nullopt: the flow at one time
  std::vector<Vec3> places{}, velocities{};  ///< centre of each cell [length], its flow [length/time]
};

/// Reads the arrows of a flow file (.vti) that belongs to the run. Throws InputError that names the file if
/// it cannot be read, is in the frame of a swimmer, lies far from the swimmers, or contains no fluid.
FlowArrows read_flow_arrows(const std::string& path, const TrajectoryFile& run);

}  // namespace beadswim
