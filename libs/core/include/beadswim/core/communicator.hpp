#pragma once

#include <mpi.h>

#include <vector>

namespace beadswim {

/// Starts MPI for as long as it lives. One in a program, in main.
class MpiSession {
 public:
  MpiSession(int* argc, char*** argv);
  ~MpiSession();
  MpiSession(const MpiSession&) = delete;
  MpiSession& operator=(const MpiSession&) = delete;
};

/// A private duplicate of an MPI communicator, freed with the object.
class Communicator {
 public:
  explicit Communicator(MPI_Comm parent);
  ~Communicator();
  Communicator(const Communicator&) = delete;
  Communicator& operator=(const Communicator&) = delete;

  MPI_Comm get() const { return comm_; }
  int rank() const { return rank_; }
  int size() const { return size_; }
  bool is_root() const { return rank_ == 0; }

 private:
  MPI_Comm comm_ = MPI_COMM_NULL;
  int rank_ = 0;
  int size_ = 1;
};

/// All ranks' bytes, rank after rank, on rank 0; empty elsewhere. At most 2 GiB in all. Collective.
std::vector<char> gather_bytes(const std::vector<char>& own, const Communicator& communicator);

/// Ranks of the communicator that share this rank's memory. Collective.
int ranks_on_this_node(const Communicator& communicator);

}  // namespace beadswim
