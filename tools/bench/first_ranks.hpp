#pragma once

#include <chrono>
#include <thread>

#include "beadswim/core/communicator.hpp"

namespace beadswim {

/// Calls `work` on the first `ranks` ranks of `world`, with a communicator of these ranks. The other ranks
/// sleep until `work` is done. Collective over `world`.
template <class Work>
void run_on_first_ranks(int ranks, const Communicator& world, Work&& work) {
  const bool active = world.rank() < ranks;
  MPI_Comm part = MPI_COMM_NULL;
  MPI_Comm_split(world.get(), active ? 0 : 1, world.rank(), &part);
  if (active) {
    const Communicator communicator(part);
    work(communicator);
  }
  MPI_Comm_free(&part);
  MPI_Request all_done;
  MPI_Ibarrier(world.get(), &all_done);
  for (int done = 0; MPI_Test(&all_done, &done, MPI_STATUS_IGNORE), done == 0;) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));  // a busy loop would use memory bandwidth
  }
}

}  // namespace beadswim
