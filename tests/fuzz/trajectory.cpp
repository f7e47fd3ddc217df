#include "memory_file.hpp"
#include "trajectory_edits.hpp"
#include "whole_trajectory.hpp"

// Trajectories that are sound HDF5 but maybe no trajectory: the bytes say what is wrong with them.

using namespace beadswim;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const MemoryFile file;
  ByteSource edits(data, size);
  write_edited_trajectory(file.path(), edits);
  require_whole_or_refused(file.path());
  return 0;
}
