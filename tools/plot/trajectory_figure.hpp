#pragma once

#include <string>
#include <vector>

#include "beadswim/figure/figure.hpp"

namespace beadswim {

struct TrajectoryFigureOptions {
  std::vector<int> swimmers{};  ///< their ids; none: all
  std::vector<int> beads{2};    ///< 1, 2, 3
  int axis = 0;                 ///< of the coordinate that is drawn: x, y, z
};

/// A coordinate of beads, not wrapped, against time in periods of the driving; a curve for each file, swimmer
/// and bead. Throws InputError for files of differing units, unknown swimmers and more curves than can be
/// told apart.
Figure trajectory_figure(const std::vector<std::string>& files, const TrajectoryFigureOptions& options);

}  // namespace beadswim
