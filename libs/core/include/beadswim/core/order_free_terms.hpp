#pragma once

#include "beadswim/core/order_free_lanes.hpp"

// For kernels, which are compiled once for each instruction set: nothing here is emitted on its own.

namespace beadswim::order_free {

constexpr int lanes = OrderFreeLanes<1>::lanes;
using Lanes = double __attribute__((vector_size(lanes * sizeof(double))));

/// Adds terms[n][0] to terms[n][places - 1] to sum n, for each of the N sums; places: a multiple of the
/// lanes. False, and nothing is added, if a term is too large, or not a number.
template <int N, int most>
BEADSWIM_KERNEL bool add_terms(const double (&terms)[N][most], int places, OrderFreeLanes<N>& sums) {
  Lanes coarse[N], fine[N];
  auto fit = Lanes{} == Lanes{};  // all true
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
      fit &= (term < largest_term) & (term > -largest_term);  // not if not a number
    }
  }
  for (int lane = 0; lane < lanes; ++lane) {
    if (!fit[lane]) return false;
  }
  __builtin_memcpy(sums.coarse, coarse, sizeof coarse);
  __builtin_memcpy(sums.fine, fine, sizeof fine);
  return true;
}

}  // namespace beadswim::order_free
