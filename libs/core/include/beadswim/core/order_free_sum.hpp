#pragma once

#include <cmath>
#include <cstdint>

// A sum whose bits do not depend on the order of its terms, and so neither on the number of ranks.
//
// Each term is cut into two integers, x = coarse 2^-30 + fine 2^-62, and integers are summed. The cut errs
// by less than 2^-62 (2.2e-19) absolute. There is room for sums up to 2^33 and for 2^31 terms at least; an
// overflow throws.

namespace beadswim {

class OrderFreeSum {
 public:
  /// Adds one term. Throws NotFiniteError unless |x| < 2^31 (so for NaN), SolverError if the sum overflows.
  void add(double x) {
    if (!(std::abs(x) < largest_term)) refuse(x);
    const std::int64_t coarse_part = std::llrint(x * coarse_per_unit);
    add(coarse, coarse_part);
    add(fine, std::llrint((x - static_cast<double>(coarse_part) / coarse_per_unit) * fine_per_unit));
  }

  void add(const OrderFreeSum& other) {
    add(coarse, other.coarse);
    add(fine, other.fine);
  }

  void subtract(const OrderFreeSum& other) {
    add(coarse, -other.coarse);
    add(fine, -other.fine);
  }

  /// Adds a sum of terms that are cut already, into whole multiples of 2^-30 below 2^33 and of 2^-62 below 2.
  void add_cut(double coarse_sum, double fine_sum) {
    add(coarse, static_cast<std::int64_t>(coarse_sum * coarse_per_unit));
    add(fine, static_cast<std::int64_t>(fine_sum * fine_per_unit));
  }

  double value() const {
    return static_cast<double>(coarse) / coarse_per_unit + static_cast<double>(fine) / fine_per_unit;
  }

  // Plain data: sums of sums are sums of these two, in messages and in MPI_SUM reductions of MPI_INT64_T.
  std::int64_t coarse = 0;
  std::int64_t fine = 0;

 private:
  static constexpr double largest_term = 0x1p31;
  static constexpr double coarse_per_unit = 0x1p30;
  static constexpr double fine_per_unit = 0x1p62;

  static void add(std::int64_t& sum, std::int64_t term) {
    if (__builtin_add_overflow(sum, term, &sum)) overflow();
  }

  [[noreturn]] static void refuse(double x);
  [[noreturn]] static void overflow();
};

}  // namespace beadswim
