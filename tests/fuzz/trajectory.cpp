#include "memory_file.hpp"
#include "trajectory_edits.hpp"
#include "whole_trajectory.hpp"

// Fuzz target: files that are valid HDF5 but possibly not valid trajectories. The bytes select the errors in
// the file.

using namespace beadswim;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const MemoryFile file;
  ByteSource edits(data, size);
  write_edited_trajectory(file.path(), edits);
  require_whole_or_refused(file.path());
  return 0;
}
