#include "one_rank.hpp"

namespace beadswim {

const Communicator& one_rank() {
  static const MpiSession session(nullptr, nullptr);
  static const Communicator communicator(MPI_COMM_WORLD);
  return communicator;
}

}  // namespace beadswim
