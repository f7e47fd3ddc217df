#pragma once

#include <cmath>
#include <cstdint>

// A sum whose bits do not depend on the order of its terms and therefore not on the number of ranks.
//
// Each term is split into two integers, x = coarse 2^-30 + fine 2^-62, which are summed separately. The
// absolute error of the splitting is less than 2^-62 (2.2e-19) per term. The range suffices for sums up to
// 2^33 and for at least 2^31 terms. Larger sums throw.

namespace beadswim {

class OrderFreeSum {
 public:
  /// Adds one term. Throws NotFiniteError unless |x| < 2^31 (NaN throws too), and SolverError if the sum
  /// overflows.
  void add(double x) {
    if (!(std::abs(x) < largest_term)) throw_out_of_range(x);
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

  /// Adds a sum of terms that are already split: `coarse_sum` is a multiple of 2^-30 below 2^33 and
  /// `fine_sum` a multiple of 2^-62 below 2, in absolute value.
  void add_split(double coarse_sum, double fine_sum) {
    add(coarse, static_cast<std::int64_t>(coarse_sum * coarse_per_unit));
    add(fine, static_cast<std::int64_t>(fine_sum * fine_per_unit));
  }

  double value() const {
    return static_cast<double>(coarse) / coarse_per_unit + static_cast<double>(fine) / fine_per_unit;
  }

  // Public data for messages and MPI reductions: MPI_SUM of these MPI_INT64_T numbers adds sums exactly.
  std::int64_t coarse = 0;
  std::int64_t fine = 0;

 private:
  static constexpr double largest_term = 0x1p31;
  static constexpr double coarse_per_unit = 0x1p30;
  static constexpr double fine_per_unit = 0x1p62;

  static void add(std::int64_t& sum, std::int64_t term) {
    if (__builtin_add_overflow(sum, term, &sum)) throw_overflow();
  }

  [[noreturn]] static void throw_out_of_range(double x);
  [[noreturn]] static void throw_overflow();
};

}  // namespace beadswim
