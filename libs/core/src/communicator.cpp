#include "beadswim/core/communicator.hpp"

namespace beadswim {

MpiSession::MpiSession(int* argc, char*** argv) {
  MPI_Init(argc, argv);
}

MpiSession::~MpiSession() {
  MPI_Finalize();
}

Communicator::Communicator(MPI_Comm parent) {
  MPI_Comm_dup(parent, &comm_);
  MPI_Comm_rank(comm_, &rank_);
  MPI_Comm_size(comm_, &size_);
}

Communicator::~Communicator() {
  MPI_Comm_free(&comm_);
}

}  // namespace beadswim
