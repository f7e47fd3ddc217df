#pragma once

#include <array>
#include <utility>

#include "beadswim/core/order_free_cut.hpp"
#include "beadswim/core/order_free_sum.hpp"

namespace beadswim {

/// N order-free sums side by side, each in 8 lanes, which kernels feed with terms that they have cut
/// (order_free_cut.hpp).
template <int N>
struct OrderFreeLanes {
  static constexpr int lanes = 8;

  double coarse[N][lanes] = {}, fine[N][lanes] = {};
  int terms = 0;  ///< in each lane, at most order_free::most_terms
  std::array<OrderFreeSum, N> sums;

  /// Makes room for so many terms in each lane.
  void make_room(int more) {
    if (terms + more > order_free::most_terms) gather();
    terms += more;
  }

  /// The sums so far, which start anew.
  std::array<OrderFreeSum, N> take() {
    gather();
    return std::exchange(sums, {});
  }

 private:
  void gather() {
    for (int n = 0; n < N; ++n) {
      for (int lane = 0; lane < lanes; ++lane) {
        sums[n].add_cut(coarse[n][lane], fine[n][lane]);
        coarse[n][lane] = fine[n][lane] = 0;
      }
    }
    terms = 0;
  }
};

}  // namespace beadswim
