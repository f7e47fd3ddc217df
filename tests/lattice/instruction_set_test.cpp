#include <gtest/gtest.h>

#include <array>
#include <random>
#include <vector>

#include "sweep_row.hpp"

namespace beadswim {
namespace {

using Kernel = void (*)(const SweepRow&);
using Rows = std::array<std::vector<double>, d3q19::directions>;

Rows random_rows(long cells) {
  std::mt19937 random(static_cast<unsigned>(cells));  // seed: the length
  std::uniform_real_distribution<double> deviation(-0.05, 0.05);
  Rows rows;
  for (auto& row : rows) {
    for (long x = 0; x < cells; ++x) row.push_back(deviation(random));
  }
  return rows;
}

Rows swept(Kernel kernel, const Rows& from, long cells) {
  Rows to;
  SweepRow row{.from = {}, .to = {}, .cells = cells, .rates = relaxation_rates(0.7)};
  for (int i = 0; i < d3q19::directions; ++i) {
    to[i].resize(cells);
    row.from[i] = from[i].data();
    row.to[i] = to[i].data();
  }
  kernel(row);
  return to;
}

// Catches a fused multiply-add or a reordered sum in one of the builds, and a remainder of a row that is
// computed in another way than its body.
TEST(SweepRow, GivesTheSameBitsOnEveryInstructionSet) {
#if defined(__x86_64__)
  for (const long cells : {1, 3, 7, 8, 9, 16, 31, 64, 121}) {
    const Rows from = random_rows(cells);
    const Rows baseline = swept(sweep_row_baseline, from, cells);
    if (__builtin_cpu_supports("x86-64-v3")) {
      EXPECT_EQ(swept(sweep_row_v3, from, cells), baseline);
    }
    if (__builtin_cpu_supports("x86-64-v4")) {
      EXPECT_EQ(swept(sweep_row_v4, from, cells), baseline);
    }
    for (long x = 0; x < cells; ++x) {  // each cell as if it were alone
      Rows alone;
      for (int i = 0; i < d3q19::directions; ++i) alone[i] = {from[i][x]};
      const Rows swept_alone = swept(sweep_row_baseline, alone, 1);
      for (int i = 0; i < d3q19::directions; ++i) ASSERT_EQ(swept_alone[i][0], baseline[i][x]);
    }
  }
#else
  GTEST_SKIP() << "one instruction set on this processor";
#endif
}

}  // namespace
}  // namespace beadswim
