#include "memory_file.hpp"
#include "whole_trajectory.hpp"

// Fuzz target: arbitrary bytes in place of a trajectory, that is, damaged HDF5 files.

using namespace beadswim;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const MemoryFile file(data, size);
  require_whole_or_refused(file.path());
  return 0;
}
