#include "beadswim/core/median.hpp"

#include <gtest/gtest.h>

namespace beadswim {
namespace {

TEST(Median, IsTheMiddleOneOrTheMeanOfTwo) {
  EXPECT_EQ(median({3}), 3);
  EXPECT_EQ(median({9, -1, 2}), 2);
  EXPECT_EQ(median({8, 1, 4, 2}), 3);
}

}  // namespace
}  // namespace beadswim
