#pragma once

#include <mpi.h>

#include <cstdint>
#include <iterator>
#include <utility>
#include <vector>

namespace beadswim {

/// Initialises MPI in the constructor and finalises it in the destructor. A program creates one MpiSession,
/// in main.
class MpiSession {
 public:
  MpiSession(int* argc, char*** argv);
  ~MpiSession();
  MpiSession(const MpiSession&) = delete;
  MpiSession& operator=(const MpiSession&) = delete;
};

/// A private duplicate of an MPI communicator, freed with the object; or this process alone.
class Communicator {
 public:
  Communicator() = default;  ///< this process alone, without MPI: needs no MpiSession, get() is null
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

/// Copies bytes (std::string or std::vector<char>, at most 2 GiB) from rank `root` to all ranks. Collective.
template <class Bytes>
void broadcast(Bytes& bytes, const Communicator& communicator, int root = 0) {
  std::int64_t size = std::ssize(bytes);
  MPI_Bcast(&size, 1, MPI_INT64_T, root, communicator.get());
  bytes.resize(size);
  MPI_Bcast(bytes.data(), static_cast<int>(size), MPI_CHAR, root, communicator.get());
}

/// Copies numbers from rank 0 to all ranks. Collective.
inline void broadcast_doubles(double* numbers, std::size_t count, const Communicator& communicator) {
  if (communicator.size() > 1) MPI_Bcast(numbers, static_cast<int>(count), MPI_DOUBLE, 0, communicator.get());
}

/// Returns the number of ranks of the communicator that share memory with this rank, this rank included.
/// Collective.
int count_ranks_on_node(const Communicator& communicator);

/// Returns the half-open range [first, end) of the indices that belong to one rank, if n consecutive elements
/// are divided evenly among the ranks.
inline std::pair<std::int64_t, std::int64_t> rank_share(std::int64_t n, int rank, int ranks) {
  return {n * rank / ranks, n * (rank + 1) / ranks};
}

/// Number and total size of the messages that one rank has sent to other ranks.
struct Traffic {
  std::int64_t messages = 0;
  std::int64_t bytes = 0;

  void add_message(std::int64_t size) {
    ++messages;
    bytes += size;
  }
  void add(const Traffic& other) {
    messages += other.messages;
    bytes += other.bytes;
  }
};

}  // namespace beadswim
