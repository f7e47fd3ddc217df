#include "sum_over_ranks.hpp"

#include <algorithm>
#include <vector>

namespace beadswim {

void sum_over_ranks(std::span<double> numbers, const Communicator& communicator) {
  const int ranks = communicator.size();
  if (ranks == 1) return;
  const std::size_t each = (numbers.size() + ranks - 1) / ranks;
  std::vector<double> parts(numbers.begin(), numbers.end());
  parts.resize(each * ranks, 0.0);
  std::vector<double> arrived(each * ranks), sums(each, 0.0);
  const int count = static_cast<int>(each);
  MPI_Alltoall(parts.data(), count, MPI_DOUBLE, arrived.data(), count, MPI_DOUBLE, communicator.get());
  for (int r = 0; r < ranks; ++r)
    for (std::size_t k = 0; k < each; ++k) sums[k] += arrived[r * each + k];
  MPI_Allgather(sums.data(), count, MPI_DOUBLE, parts.data(), count, MPI_DOUBLE, communicator.get());
  std::copy_n(parts.begin(), numbers.size(), numbers.begin());
}

}  // namespace beadswim
