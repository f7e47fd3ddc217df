#pragma once

#include <array>
#include <utility>

#include "beadswim/core/lanes.hpp"
#include "beadswim/core/order_free_cut.hpp"
#include "beadswim/core/order_free_sum.hpp"

namespace beadswim {

/// N sums whose bits do not depend on the order of their terms (order_free_sum.hpp). Each sum has 8 partial
/// sums, the lanes of a vector register. Kernels add terms that are already split into coarse and fine parts
/// (order_free_cut.hpp).
template <int N>
struct OrderFreeLanes {
  static constexpr int lanes = beadswim::lanes;

  double coarse[N][lanes] = {}, fine[N][lanes] = {};
  int terms = 0;  ///< terms added to each lane since it was last emptied, at most order_free::max_terms
  std::array<OrderFreeSum, N> sums;

  /// Prepares each lane for `more` additional terms. If a lane would then contain more than
  /// order_free::max_terms terms, first adds all lanes to `sums` and empties them.
  void reserve_terms(int more) {
    if (terms + more > order_free::max_terms) gather();
    terms += more;
  }

  /// Returns the sums and resets them to zero.
  std::array<OrderFreeSum, N> take() {
    gather();
    return std::exchange(sums, {});
  }

 private:
  void gather() {
    for (int n = 0; n < N; ++n) {
      for (int lane = 0; lane < lanes; ++lane) {
        sums[n].add_split(coarse[n][lane], fine[n][lane]);
        coarse[n][lane] = fine[n][lane] = 0;
      }
    }
    terms = 0;
  }
};

}  // namespace beadswim
