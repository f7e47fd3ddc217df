#pragma once

#include <cstdint>
#include <utility>

namespace beadswim {

/// First and end of one rank's share of n things in a row.
inline std::pair<std::int64_t, std::int64_t> rank_share(std::int64_t n, int rank, int ranks) {
  return {n * rank / ranks, n * (rank + 1) / ranks};
}

}  // namespace beadswim
