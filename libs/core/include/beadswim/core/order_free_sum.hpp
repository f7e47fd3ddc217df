#pragma once

#include <cmath>
#include <cstdint>

// A sum whose bits do not depend on the order of its terms and therefore not on the number of ranks.
//
// Each term x is split into two integers, x = coarse 2^-30 + fine 2^-62. The two integers are summed
// separately. The absolute error of the splitting is less than 2^-62 (2.2e-19) per term. The range suffices
// for sums up to 2^33 and for at least 2^31 terms. A larger sum throws SolverError.

namespace beadswim {

class OrderFreeSum {
 public:
  /// Adds one term. Throws NotFiniteError if x is NaN or |x| >= 2^31. Throws SolverError if the sum
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

  /// Adds the sum of several terms that are already split into coarse and fine parts. `coarse_sum` is a
  /// multiple of 2^-30 with |coarse_sum| < 2^33. `fine_sum` is a multiple of 2^-62 with |fine_sum| < 2.
  void add_split(double coarse_sum, double fine_sum) {
    add(coarse, static_cast<std::int64_t>(coarse_sum * coarse_per_unit));
    add(fine, static_cast<std::int64_t>(fine_sum * fine_per_unit));
  }

  double value() const {
    return static_cast<double>(coarse) / coarse_per_unit + static_cast<double>(fine) / fine_per_unit;
  }

  // These members are public so that messages and MPI reductions can access them. A reduction of both
  // integers with MPI_SUM and MPI_INT64_T adds OrderFreeSums exactly.
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
