#include "beadswim/core/communicator.hpp"

#include <cstdlib>
#include <limits>
#include <numeric>

#include "beadswim/core/error.hpp"

namespace beadswim {

MpiSession::MpiSession(int* argc, char*** argv) {
  hold_closed_streams();
  // Open MPI 4 gives all processes without mpirun one folder, and the first that ends deletes it while
  // another starts: 1 of 100 starts failed with four programs at a time. Without mpirun there is no use for
  // the folder, nor for the daemon. With it, the folder is needed.
  const bool launched = std::getenv("PMIX_NAMESPACE") || std::getenv("PMI_RANK") || std::getenv("PMI_FD");
  constexpr const char* create_folders = "OMPI_MCA_orte_create_session_dirs";
  if (!launched) {
    setenv("OMPI_MCA_ess_singleton_isolated", "1", 0);
    setenv(create_folders, "0", 0);
  }
  MPI_Init(argc, argv);
  if (!launched) unsetenv(create_folders);  // a command that this process starts may be mpirun
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
  if (comm_ != MPI_COMM_NULL) MPI_Comm_free(&comm_);
}

std::vector<char> gather_bytes(const std::vector<char>& own, const Communicator& communicator) {
  const int bytes = static_cast<int>(own.size());
  std::vector<int> sizes(communicator.size()), starts(communicator.size());
  MPI_Gather(&bytes, 1, MPI_INT, sizes.data(), 1, MPI_INT, 0, communicator.get());
  if (std::accumulate(sizes.begin(), sizes.end(), 0L) > std::numeric_limits<int>::max())
    throw SolverError(
        "one MPI rank cannot collect more than 2 GiB of data from the other ranks; use fewer swimmers, or a "
        "smaller cell of the scene (beadswim-layout reduce)");
  std::exclusive_scan(sizes.begin(), sizes.end(), starts.begin(), 0);
  std::vector<char> all(communicator.is_root() ? starts.back() + sizes.back() : 0);
  MPI_Gatherv(own.data(), bytes, MPI_BYTE, all.data(), sizes.data(), starts.data(), MPI_BYTE, 0,
              communicator.get());
  return all;
}

int count_ranks_on_node(const Communicator& communicator) {
  MPI_Comm node = MPI_COMM_NULL;
  int ranks = 1;
  MPI_Comm_split_type(communicator.get(), MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &node);
  MPI_Comm_size(node, &ranks);
  MPI_Comm_free(&node);
  return ranks;
}

}  // namespace beadswim
