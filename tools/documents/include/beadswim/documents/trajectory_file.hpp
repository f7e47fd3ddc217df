#pragma once

#include <string>
#include <vector>

#include "beadswim/io/trajectory_reader.hpp"
#include "beadswim/scene/layout.hpp"

namespace beadswim {

/// A trajectory and the layout of its run.
struct TrajectoryFile {
  std::string source;
  TrajectoryReader reader;
  Layout layout;
  std::vector<std::size_t> in_layout;  ///< index into layout.swimmers of each swimmer in the file

  double period() const;              ///< driving period of the first swimmer [time]
  std::vector<int> swimmers() const;  ///< ids, in the order of the file
};

/// Opens a trajectory and reads its layout. Throws InputError, which names file and place, if it is invalid.
TrajectoryFile open_trajectory(const std::string& path);

/// Throws InputError with a message such as "FLAG: no swimmer 12 in run.h5md; the nearest is 8, ids are 0 to
/// 8".
[[noreturn]] void throw_unknown_swimmer(const std::string& flag, int id, const std::vector<int>& ids,
                                        const std::string& source);

}  // namespace beadswim
