#include <gtest/gtest.h>

#include "beadswim/compare/cycle_statistics.hpp"
#include "beadswim/compare/result_quantity.hpp"
#include "tolerances.hpp"

namespace beadswim {
namespace {

const Box all_periodic{.lengths = {90, 80, 70}, .boundary = {}};
const std::optional<Box> open_space;

CycleStatistics some_cycle() {
  CycleStatistics cycle;
  cycle.velocity = Vec3(5, 2, 0);
  cycle.mean_flow = Vec3(1, 1, 0);
  cycle.axis = Vec3(0.6, 0.8, 0);
  return cycle;
}

// A swimmer carried by a uniform flow swims no faster.
TEST(VelocityAgainstFluid, IsGalileiInvariantAlongPeriodicAxes) {
  CycleStatistics cycle = some_cycle();
  const double before = velocity_relative_to_fluid(cycle, all_periodic);
  const Vec3 wind(0.3, -7, 2);
  cycle.velocity += wind;
  cycle.mean_flow += wind;
  EXPECT_NEAR(velocity_relative_to_fluid(cycle, all_periodic), before, roundoff(20) * wind.norm());
}

TEST(VelocityAgainstFluid, SubtractsTheFlowAlongPeriodicAxesAlone) {
  EXPECT_DOUBLE_EQ(velocity_relative_to_fluid(some_cycle(), all_periodic), 0.6 * 4 + 0.8 * 1);
  EXPECT_DOUBLE_EQ(velocity_relative_to_fluid(some_cycle(), open_space), 0.6 * 5 + 0.8 * 2);
  EXPECT_DOUBLE_EQ(velocity_relative_to_fluid(
                       some_cycle(), Box{all_periodic.lengths,
                                         {Boundary::periodic, Boundary::no_slip, Boundary::periodic}}),
                   0.6 * 4 + 0.8 * 2);
}

TEST(QuantityNames, RoundTrip) {
  for (const ResultQuantity quantity : all_values<ResultQuantity>)
    EXPECT_EQ(value_named<ResultQuantity>(to_text(quantity)), quantity);
  EXPECT_EQ(value_named<ResultQuantity>("speed"), std::nullopt);
}

}  // namespace
}  // namespace beadswim
