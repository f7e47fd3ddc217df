#pragma once

#include <string>
#include <vector>

#include "beadswim/io/trajectory_reader.hpp"
#include "beadswim/scene/layout.hpp"

namespace beadswim {

/// A trajectory with the layout that was run.
struct TrajectoryFile {
  std::string source;
  TrajectoryReader reader;
  Layout layout;
  std::vector<std::size_t> in_layout;  ///< index among the layout's swimmers of each of the file's

  double period() const;              ///< of the driving of all swimmers [time]
  std::vector<int> swimmers() const;  ///< their ids, in the order of the file
};

/// Throws InputError naming file and place.
TrajectoryFile open_trajectory(const std::string& path);

/// "FLAG: no swimmer 12 in run.h5md; the nearest is 8, ids are 0 to 8", as an InputError.
[[noreturn]] void refuse_swimmer(const std::string& flag, int id, const std::vector<int>& ids,
                                 const std::string& source);

}  // namespace beadswim
