#pragma once

#include <cstdint>
#include <utility>

namespace beadswim {

/// Returns the half-open range [first, end) of the indices that belong to one rank, if n consecutive elements
/// are divided evenly among the ranks.
inline std::pair<std::int64_t, std::int64_t> rank_share(std::int64_t n, int rank, int ranks) {
  return {n * rank / ranks, n * (rank + 1) / ranks};
}

}  // namespace beadswim
