#pragma once

#include <mpi.h>

#include <vector>

namespace beadswim {

/// Initialises MPI in the constructor and finalises it in the destructor. A program has one, in main.
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

/// Gathers the bytes of all ranks on rank 0, in the order of the ranks. Returns an empty vector on other
/// ranks. Throws SolverError on rank 0 if the total exceeds 2 GiB. Collective.
std::vector<char> gather_bytes(const std::vector<char>& own, const Communicator& communicator);

/// Returns the number of ranks of the communicator that share memory with this rank, itself included.
/// Collective.
int count_ranks_on_node(const Communicator& communicator);

}  // namespace beadswim
