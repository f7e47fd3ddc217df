#pragma once

#include "beadswim/core/kernel.hpp"

// Near part of an Ewald sum as polynomials. This file contains no functions that a compiler could emit, so that
// kernels can include it.

namespace beadswim {

/// Coefficients by powers of w = 1 - r^2/cutoff^2. All are positive, so that sums of them lose no digits.
struct SplitPolynomials {
  static constexpr int max_terms = 160, highest = 8;
  int terms = 0;
  double inverse_square = 0;           ///< 1/cutoff^2 [1/length^2]
  double below = 0, above = 0;         ///< D_(n-1) = 2 n below D_n + above w D_(n+1)
  double mean[max_terms]{};            ///< of A_0 [1/length]
  double bells[2][max_terms]{};        ///< of D_8 and D_9 (ewald_split.hpp)
};

template <class Value>
BEADSWIM_KERNEL Value polynomial(const double* coefficients, int terms, Value w) {
  Value sum = Value{} + coefficients[terms - 1];
#pragma GCC unroll 1
  for (int k = terms - 2; k >= 0; --k) sum = sum * w + coefficients[k];
  return sum;
}

/// Sets the functions of MomentRadials to those of the near part at the distance r, up to n = `highest`. unit:
/// 1/(8 pi eta). Value: double, or a vector of doubles.
template <class Value>
BEADSWIM_KERNEL void near_functions(const SplitPolynomials& split, double unit, Value r, Value* chi,
                                    Value* laplacian, Value* bilaplacian) {
  constexpr int highest = SplitPolynomials::highest;
  const Value r2 = r * r, w = 1 - r2 * split.inverse_square;
  Value D[highest + 2];
  D[highest] = unit * polynomial(split.bells[0], split.terms, w);
  D[highest + 1] = unit * polynomial(split.bells[1], split.terms, w);
#pragma GCC unroll 8
  for (int n = highest; n > 0; --n) D[n - 1] = 2 * n * split.below * D[n] + split.above * w * D[n + 1];
  const Value inverse = 1 / r2;
  Value B = unit * (1 / r - polynomial(split.mean, split.terms, w));
  double sign = 1;
#pragma GCC unroll 9
  for (int n = 0; n <= highest; ++n) {
    if (n < highest) chi[n + 1] = sign * B;
    laplacian[n] = sign * (2 * B - D[n]);
    if (n <= highest - 2) bilaplacian[n] = sign * ((5 + 2 * n) * D[n + 1] - r2 * D[n + 2]);
    B = ((2 * n + 1) * B + D[n]) * inverse;
    sign = -sign;
  }
}

}  // namespace beadswim
