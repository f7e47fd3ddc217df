#include "beadswim/core/names.hpp"

#include <gmock/gmock.h>

#include "beadswim/core/box.hpp"

namespace beadswim {
namespace {

TEST(Names, RoundTripAndStandInTheOrderOfTheTable) {
  EXPECT_THAT(all_names<Boundary>(), testing::ElementsAre("periodic", "free-slip", "no-slip"));
  for (const Boundary boundary : all_values<Boundary>)
    EXPECT_EQ(from_text<Boundary>(to_text(boundary)), boundary);
  EXPECT_EQ(value_named<Boundary>("wall"), std::nullopt);
}

TEST(Names, AnUnknownOneIsRefusedWithTheNearestAndAllAllowed) {
  try {
    from_text<Boundary>("no_slip");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(
        error.what(),
        "unknown value \"no_slip\"; did you mean \"no-slip\"? Valid values: periodic, free-slip, no-slip");
  }
}

}  // namespace
}  // namespace beadswim
