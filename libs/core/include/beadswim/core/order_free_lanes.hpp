#pragma once

#include <array>
#include <utility>

#include "beadswim/core/order_free_cut.hpp"
#include "beadswim/core/order_free_sum.hpp"

namespace beadswim {

/// N order-free sums, each with 8 partial sums (lanes). Kernels add terms that are split into coarse and fine
/// parts (order_free_cut.hpp).
template <int N>
struct OrderFreeLanes {
  static constexpr int lanes = 8;

  double coarse[N][lanes] = {}, fine[N][lanes] = {};
  int terms = 0;  ///< number of terms in each lane, at most order_free::max_terms
  std::array<OrderFreeSum, N> sums;

  /// Prepares each lane for `more` further terms: moves the lanes into the sums if they would exceed the
  /// maximum.
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
