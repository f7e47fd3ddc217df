#pragma once

#include "beadswim/core/order_free_lanes.hpp"

// Addition of terms to order-free sums inside kernels. Kernels are compiled once per instruction set, so all
// functions in this file are always inlined (kernel.hpp).

namespace beadswim::order_free {

/// Adds the terms terms[n][0], ..., terms[n][places - 1] to sum n, for each of the N sums. `places` is a
/// multiple of the number of lanes. If a term is NaN or |term| >= largest_term, adds nothing and returns
/// false.
template <int N, int capacity>
BEADSWIM_KERNEL bool add_terms(const double (&terms)[N][capacity], int places, OrderFreeLanes<N>& sums) {
  Lanes coarse[N], fine[N];
  auto are_valid = Lanes{} == Lanes{};  // starts with true in all lanes
  __builtin_memcpy(coarse, sums.coarse, sizeof coarse);
  __builtin_memcpy(fine, sums.fine, sizeof fine);
#pragma GCC unroll 12
  for (int n = 0; n < N; ++n) {
    for (int k = 0; k < places; k += lanes) {
      Lanes term;
      __builtin_memcpy(&term, &terms[n][k], sizeof term);
      const Lanes multiple = coarse_part(term);
      coarse[n] += multiple;
      fine[n] += fine_part(term, multiple);
      are_valid &= (term < largest_term) & (term > -largest_term);  // false for NaN
    }
  }
  for (int lane = 0; lane < lanes; ++lane) {
    if (!are_valid[lane]) return false;
  }
  __builtin_memcpy(sums.coarse, coarse, sizeof coarse);
  __builtin_memcpy(sums.fine, fine, sizeof fine);
  return true;
}

}  // namespace beadswim::order_free
