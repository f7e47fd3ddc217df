#include "beadswim/core/order_free_sum.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "beadswim/core/error.hpp"

namespace beadswim {
namespace {

std::vector<double> terms_of_many_sizes() {
  std::mt19937 random(7);  // seed 7
  std::uniform_real_distribution<double> mantissa(-1, 1), exponent(-40, 8);
  std::vector<double> terms;
  for (int n = 0; n < 10000; ++n)
    terms.push_back(std::ldexp(mantissa(random), static_cast<int>(exponent(random))));
  return terms;
}

OrderFreeSum sum_of(const std::vector<double>& terms) {
  OrderFreeSum sum;
  for (const double term : terms) sum.add(term);
  return sum;
}

TEST(OrderFreeSum, HasTheSameBitsInAnyOrderAndGrouping) {
  std::vector<double> terms = terms_of_many_sizes();
  const OrderFreeSum forwards = sum_of(terms);
  std::ranges::shuffle(terms, std::mt19937(8));  // seed 8
  OrderFreeSum in_two_parts = sum_of({terms.begin(), terms.begin() + 3333});
  in_two_parts.add(sum_of({terms.begin() + 3333, terms.end()}));
  EXPECT_EQ(forwards.value(), in_two_parts.value());
  EXPECT_EQ(forwards.coarse, in_two_parts.coarse);
  EXPECT_EQ(forwards.fine, in_two_parts.fine);
}

TEST(OrderFreeSum, ErrsByNoMoreThanItsCut) {
  const std::vector<double> terms = terms_of_many_sizes();
  long double exact = 0;
  for (const double term : terms) exact += term;
  const double cut = std::ldexp(1.0, -62) * static_cast<double>(terms.size());
  const double last_digit = std::abs(static_cast<double>(exact)) * std::numeric_limits<double>::epsilon();
  EXPECT_NEAR(sum_of(terms).value(), static_cast<double>(exact), cut + 2 * last_digit);
}

TEST(OrderFreeSum, CancelsExactly) {
  OrderFreeSum sum;
  for (const double term : {0.1, 1e5, -0.1, 3e-17, -1e5, -3e-17}) sum.add(term);
  EXPECT_EQ(sum.value(), 0);
}

TEST(OrderFreeSum, RefusesWhatItCannotHold) {
  OrderFreeSum sum;
  EXPECT_THROW(sum.add(std::nan("")), SolverError);
  EXPECT_THROW(sum.add(std::numeric_limits<double>::infinity()), SolverError);
  EXPECT_THROW(sum.add(-4e9), SolverError);
}

}  // namespace
}  // namespace beadswim
