#pragma once

#include <string>
#include <vector>

#include "beadswim/documents/run_record_document.hpp"
#include "beadswim/io/h5md.hpp"
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
  /// Returns the type of a swimmer, which is given by its index in the file.
  const SwimmerType& type(std::size_t swimmer) const;
};

/// Returns the number of cycles, if the time is the end of a cycle within roundoff.
std::optional<int> whole_cycles(double time, double period);

/// Returns true if the file name has the ending of a trajectory, or if the file is in HDF5 format.
bool is_trajectory(const std::string& path);

/// Opens a trajectory file and reads the layout that it contains. Throws InputError if the file is invalid;
/// the message contains the path of the file and the place within it.
TrajectoryFile open_trajectory(const std::string& path);

/// Returns what a trajectory contains of the record of its run: scene, driving, and the cycles of all
/// swimmers. Its model is "trajectory". Throws InputError if the file is invalid.
RunRecord run_of_trajectory(const std::string& path);

/// Returns the index of an id in the ids of swimmers. Throws InputError if no swimmer has it, with a message
/// such as "FLAG: no swimmer 12 in run.h5md; the nearest is 8, ids are 0 to 8".
std::size_t swimmer_with_id(int id, const std::vector<int>& ids, const std::string& flag,
                            const std::string& source);

}  // namespace beadswim
