#include <gtest/gtest.h>

#include <vector>

#include "beadswim/compare/cycle_choice.hpp"
#include "beadswim/core/error.hpp"

namespace beadswim {
namespace {

/// Returns cycle statistics with the given cycle numbers. The numbers of a restarted run may begin later than
/// 1.
std::vector<CycleStatistics> cycles_numbered(std::initializer_list<int> indices) {
  std::vector<CycleStatistics> cycles;
  for (const int index : indices) {
    cycles.emplace_back();
    cycles.back().index = index;
  }
  return cycles;
}

std::vector<int> indices_chosen(const std::vector<CycleStatistics>& cycles, const std::string& choice) {
  std::vector<int> indices;
  for (const CycleStatistics& cycle : select_cycles(cycles, parse_cycle_choice(choice), "r.json")) {
    indices.push_back(cycle.index);
  }
  return indices;
}

TEST(CycleChoice, CountsByIndexAndFromTheEnd) {
  const auto cycles = cycles_numbered({3, 4, 5, 6});
  EXPECT_EQ(indices_chosen(cycles, "last"), (std::vector{6}));
  EXPECT_EQ(indices_chosen(cycles, "3"), (std::vector{3}));
  EXPECT_EQ(indices_chosen(cycles, "mean:3"), (std::vector{4, 5, 6}));
  EXPECT_EQ(indices_chosen(cycles, "mean:4"), (std::vector{3, 4, 5, 6}));
}

TEST(CycleChoice, RefusesCyclesThatTheRunLacks) {
  const auto cycles = cycles_numbered({3, 4, 5, 6});
  EXPECT_THROW(indices_chosen(cycles, "1"), InputError);
  EXPECT_THROW(indices_chosen(cycles, "7"), InputError);
  EXPECT_THROW(indices_chosen(cycles, "mean:5"), InputError);
  EXPECT_THROW(indices_chosen({}, "last"), InputError);
}

TEST(CycleChoice, RefusesWhatIsNoChoice) {
  for (const char* text : {"", "first", "0", "-1", "1.5", "2x", "mean", "mean:", "mean:0", "99999999999"}) {
    EXPECT_THROW(parse_cycle_choice(text), InputError) << text;
  }
}

}  // namespace
}  // namespace beadswim
