#include "accepted.hpp"
#include "beadswim/io/checkpoint_file.hpp"
#include "hdf5_handles.hpp"
#include "memory_file.hpp"
#include "one_rank.hpp"

// Fuzz target: arbitrary bytes in place of a checkpoint. If the checkpoint is accepted, its contents agree
// with its hash, so all its sections must be readable.

using namespace beadswim;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const MemoryFile file(data, size);
  one_rank();
  require_all_closed_by([&] {
    accepts([&] {
      const CheckpointReader checkpoint(file.path(), one_rank());
      require(checkpoint.text("layout").size() == checkpoint.size("layout"), "sections can be read");
    });
  });
  return 0;
}
