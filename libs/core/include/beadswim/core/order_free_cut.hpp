#pragma once

#include "beadswim/core/kernel.hpp"

// The cut of OrderFreeSum in plain doubles, for loops that are to run in lanes.
//
// Adding 3/2 x 2^22 to a number below 2^21 and taking it away again rounds the number to a whole multiple of
// 2^-30, ties to even, as OrderFreeSum does. 4096 such multiples below 2^10 add up exactly, in any order. The
// remainders likewise, in units of 2^-62.

namespace beadswim::order_free {

constexpr double largest_term = 0x1p10;  ///< terms are smaller
constexpr int most_terms = 4096;         ///< that may be added up in doubles

// Value: double, or a vector of doubles.

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

}  // namespace beadswim::order_free
