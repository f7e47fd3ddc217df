#pragma once

#include <array>
#include <utility>

#include "beadswim/core/kernel.hpp"
#include "beadswim/core/order_free_sum.hpp"

// Terms of OrderFreeSums (sums whose bits do not depend on the order of their terms) in vectorised loops:
// each term is split into a coarse and a fine part, in double precision.
//
// Adding and then subtracting 1.5 * 2^22 rounds a number x with |x| < 2^21 to a multiple of 2^-30, ties to
// even, as OrderFreeSum does. This multiple is the coarse part. The fine part is the remainder, rounded in
// the same way to a multiple of 2^-62. The sum of up to 4096 coarse parts with absolute values below 2^10 is
// exact in double precision, in any order. The sum of their fine parts is exact too.

namespace beadswim {
namespace order_free {

constexpr double largest_term = 0x1p10;  ///< exclusive upper bound of |term|
constexpr int max_terms = 4096;          ///< maximum number of terms whose parts have exact sums in doubles

// In the following two functions, `Value` is double or a vector of doubles.

template <class Value>
BEADSWIM_KERNEL Value coarse_part(Value x) {
  constexpr double rounder = 0x1.8p22;
  return x + rounder - rounder;
}
template <class Value>
BEADSWIM_KERNEL Value fine_part(Value x, Value coarse) {
  constexpr double rounder = 0x1.8p-10;
  return x - coarse + rounder - rounder;
}

}  // namespace order_free

/// N OrderFreeSums. Each has 8 partial sums, the lanes of a vector register, to which kernels add terms.
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

namespace order_free {

/// The partial sums of N OrderFreeSums in vector registers, while a kernel adds terms to them.
template <int N>
struct LaneSums {
  Lanes coarse[N], fine[N];
  decltype(Lanes{} < Lanes{}) are_valid = Lanes{} == Lanes{};  ///< per lane: no term was too large or NaN

  BEADSWIM_KERNEL explicit LaneSums(const OrderFreeLanes<N>& sums) {
    __builtin_memcpy(coarse, sums.coarse, sizeof coarse);
    __builtin_memcpy(fine, sums.fine, sizeof fine);
  }

  /// Adds a term to each lane of sum n.
  BEADSWIM_KERNEL void add(int n, Lanes term) {
    const Lanes multiple = coarse_part(term);
    coarse[n] += multiple;
    fine[n] += fine_part(term, multiple);
    are_valid &= (term < largest_term) & (term > -largest_term);  // false for NaN
  }

  /// Stores the partial sums. If a term was NaN or |term| >= largest_term, stores nothing and returns false.
  BEADSWIM_KERNEL bool store_in(OrderFreeLanes<N>& sums) const {
    for (int lane = 0; lane < lanes; ++lane) {
      if (!are_valid[lane]) return false;
    }
    __builtin_memcpy(sums.coarse, coarse, sizeof coarse);
    __builtin_memcpy(sums.fine, fine, sizeof fine);
    return true;
  }
};

/// Adds the terms terms[n][0], ..., terms[n][places - 1] to sum n, for each of the N sums. `places` is a
/// multiple of the number of lanes. If a term is NaN or |term| >= largest_term, adds nothing and returns
/// false.
template <int N, int capacity>
BEADSWIM_KERNEL bool add_terms(const double (&terms)[N][capacity], int places, OrderFreeLanes<N>& sums) {
  LaneSums<N> partial(sums);
#pragma GCC unroll 12
  for (int n = 0; n < N; ++n) {
    for (int k = 0; k < places; k += lanes) partial.add(n, load(&terms[n][k]));
  }
  return partial.store_in(sums);
}

}  // namespace order_free
}  // namespace beadswim
