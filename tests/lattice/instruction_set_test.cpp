#include <gtest/gtest.h>

#include <array>
#include <random>
#include <vector>

#include "beadswim/core/order_free_sum.hpp"
#include "row_kernels.hpp"

namespace beadswim {
namespace {

template <class Real>
using Rows = std::array<std::vector<Real>, d3q19::directions>;

template <class Real>
Rows<Real> random_rows(long cells) {
  std::mt19937 random(static_cast<unsigned>(cells));  // seed: the length
  std::uniform_real_distribution<double> deviation(-0.05, 0.05);
  Rows<Real> rows;
  for (auto& row : rows) {
    for (long x = 0; x < cells; ++x) {  // every third cell so slow that its terms must be cut
      row.push_back(static_cast<Real>(deviation(random) * (x % 3 == 0 ? 1e-7 : 1)));
    }
  }
  return rows;
}

/// Returns the kernels for all instruction sets that this processor supports.
std::vector<RowKernels> kernels() {
  std::vector<RowKernels> kernels{RowKernels::baseline};
  if (__builtin_cpu_supports("x86-64-v3")) kernels.push_back(RowKernels::x86_64_v3);
  if (__builtin_cpu_supports("x86-64-v4")) kernels.push_back(RowKernels::x86_64_v4);
  return kernels;
}

template <class Real>
Rows<Real> swept(const RowKernels& kernels, const Rows<Real>& from, long cells,
                 const BodyForce<Real>& force = {}) {
  Rows<Real> places = from;
  SweepRow<Real> row{.incoming = {},
                     .first = 0,
                     .cells = cells,
                     .rates = collision_rates<Real>(relaxation_rates(0.7)),
                     .force = force};
  for (int i = 0; i < d3q19::directions; ++i) row.incoming[i] = places[i].data();
  kernels.sweep(row);
  Rows<Real> outgoing;
  for (int i = 0; i < d3q19::directions; ++i) {
    places[i].resize(cells);
    outgoing[i] = places[d3q19::opposite(i)];
  }
  return outgoing;
}

template <class Real>
Rows<Real> one_cell_of(const Rows<Real>& rows, long x) {
  Rows<Real> alone;
  for (int i = 0; i < d3q19::directions; ++i) alone[i] = {rows[i][x]};
  return alone;
}

constexpr std::array row_lengths{1L, 3L, 7L, 8L, 9L, 16L, 24L, 31L, 64L, 121L};

template <class Real>
class RowKernelsOf : public testing::Test {};
using Reals = testing::Types<double, float>;
TYPED_TEST_SUITE(RowKernelsOf, Reals);

// Catches a fused multiply-add or a reordered sum in one of the builds, and a remainder of a row that is
// computed in another way than its body.
TYPED_TEST(RowKernelsOf, SweepGivesTheSameBitsOnEveryInstructionSet) {
  using Real = TypeParam;
  const BodyForce<Real> upwards{.twelfth = {Real(3e-5), Real(-2e-7), Real(1e-4)}, .acts = true};
  for (const BodyForce<Real>& force : {BodyForce<Real>{}, upwards}) {
    for (const long cells : row_lengths) {
      const Rows<Real> from = random_rows<Real>(cells);
      const Rows<Real> expected = swept(kernels().front(), from, cells, force);
      for (const RowKernels& other : kernels()) {
        EXPECT_EQ(swept(other, from, cells, force), expected) << other.instruction_set;
      }
      for (long x = 0; x < cells; ++x) {
        EXPECT_EQ(swept(kernels().front(), one_cell_of(from, x), 1, force), one_cell_of(expected, x));
      }
    }
  }
}

// Catches a wrong weight or sign in the force, by the difference of equilibria that defines it.
TYPED_TEST(RowKernelsOf, BodyForceMovesPopulationsFromEquilibriumToEquilibrium) {
  using Real = TypeParam;
  const std::array<double, 3> g{3e-3, -2e-3, 5e-3};
  const BodyForce<Real> force{.twelfth = {Real(g[0] / 12), Real(g[1] / 12), Real(g[2] / 12)}, .acts = true};
  const Rows<Real> from = random_rows<Real>(31);
  const Rows<Real> without = swept(kernels().front(), from, 31),
                   with = swept(kernels().front(), from, 31, force);
  for (long x = 0; x < 31; ++x) {
    double f[d3q19::directions], r, u[3];
    for (int i = 0; i < d3q19::directions; ++i) f[i] = static_cast<double>(without[i][x]);
    moments_of(f, r, u);
    for (int i = 0; i < d3q19::directions; ++i) {
      const double difference =
          equilibrium(i, r, u[0] + g[0], u[1] + g[1], u[2] + g[2]) - equilibrium(i, r, u[0], u[1], u[2]);
      const double roundoff = 0.5 * std::numeric_limits<Real>::epsilon();
      EXPECT_NEAR(static_cast<double>(with[i][x]) - f[i], difference, roundoff) << i;
    }
  }
}

/// Returns the density deviation and momentum of the row, summed term by term.
template <class Real>
std::array<OrderFreeSum, 4> totals_one_by_one(const Rows<Real>& rows, long cells) {
  std::array<OrderFreeSum, 4> sums;
  for (long x = 0; x < cells; ++x) {
    double f[d3q19::directions], r, u[3];
    for (int i = 0; i < d3q19::directions; ++i) f[i] = static_cast<double>(rows[i][x]);
    moments_of(f, r, u);
    sums[0].add(r);
    for (int a = 0; a < 3; ++a) sums[a + 1].add(u[a]);
  }
  return sums;
}

template <class Real>
TotalsRow<Real> as_row(const Rows<Real>& rows, long cells) {
  TotalsRow<Real> row{.outgoing = {}, .cells = cells};
  for (int i = 0; i < d3q19::directions; ++i) row.outgoing[i] = rows[i].data();
  return row;
}

// Catches a cut that rounds otherwise than OrderFreeSum's, and lanes whose sums are not exact.
TYPED_TEST(RowKernelsOf, TotalsAreThoseOfTheTermsOneByOne) {
  using Real = TypeParam;
  for (const long cells : {1L, 7L, 64L, 121L, long{TotalsRow<Real>::max_cells}}) {
    const Rows<Real> rows = random_rows<Real>(cells);
    const std::array<OrderFreeSum, 4> expected = totals_one_by_one(rows, cells);
    for (const RowKernels& each : kernels()) {
      OrderFreeLanes<4> sums;
      ASSERT_TRUE(each.add_totals(as_row(rows, cells), sums));
      const std::array<OrderFreeSum, 4> totals = sums.take();
      for (int m = 0; m < 4; ++m) {
        EXPECT_EQ(totals[m].coarse, expected[m].coarse) << each.instruction_set;
        EXPECT_EQ(totals[m].fine, expected[m].fine) << each.instruction_set;
      }
    }
  }
}

// Catches a number that is not one, or is out of range, and slips through in one of the lanes.
TYPED_TEST(RowKernelsOf, TotalsSayWhenATermDoesNotFit) {
  using Real = TypeParam;
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity(), -2e3}) {
    for (const long place : {0L, 5L, 30L}) {
      Rows<Real> rows = random_rows<Real>(31);
      rows[8][place] = static_cast<Real>(bad);
      for (const RowKernels& each : kernels()) {
        OrderFreeLanes<4> sums;
        EXPECT_FALSE(each.add_totals(as_row(rows, 31), sums));
      }
    }
  }
}

}  // namespace
}  // namespace beadswim
