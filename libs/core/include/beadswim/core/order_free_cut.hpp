#pragma once

#include "beadswim/core/kernel.hpp"

// Splits the terms of an OrderFreeSum (a sum whose bits do not depend on the order of its terms) into a
// coarse and a fine part, in double precision, for vectorised loops.
//
// Adding and then subtracting 1.5 * 2^22 rounds a number x with |x| < 2^21 to a multiple of 2^-30, ties to
// even, as OrderFreeSum does. This multiple is the coarse part. The fine part is the remainder, rounded in
// the same way to a multiple of 2^-62. The sum of up to 4096 coarse parts with absolute values below 2^10 is
// exact in double precision, in any order. The sum of their fine parts is exact too.

namespace beadswim::order_free {

constexpr double largest_term = 0x1p10;  ///< exclusive upper bound of |term|
constexpr int max_terms = 4096;          ///< maximum number of terms whose parts have exact sums in doubles

// In the following functions, `Value` is double or a vector of doubles.

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
