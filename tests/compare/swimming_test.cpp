#include <gtest/gtest.h>

#include <cmath>

#include "beadswim/compare/swimming.hpp"
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
  cycle.arm_amplitudes = {2.5, 3.5};
  cycle.arm_phases = {2.0, 0.5};
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

TEST(SwimmingIn, PhaseShiftIsThatOfArm1AgainstArm2) {
  const ComparedValues swimming = evaluate_compared_values(some_cycle(), all_periodic);
  EXPECT_DOUBLE_EQ(swimming.at(ComparedQuantity::sin_phase_shift)[0], std::sin(1.5));
  EXPECT_EQ(swimming.at(ComparedQuantity::arm_amplitudes), (std::vector{2.5, 3.5}));
}

TEST(MeanSwimming, AveragesEachNumber) {
  const std::vector<ComparedValues> cycles{
      {{ComparedQuantity::velocity, {1}}, {ComparedQuantity::arm_amplitudes, {2, 10}}},
      {{ComparedQuantity::velocity, {2}}, {ComparedQuantity::arm_amplitudes, {4, 30}}}};
  const ComparedValues mean = average_compared_values(cycles);
  EXPECT_DOUBLE_EQ(mean.at(ComparedQuantity::velocity)[0], 1.5);
  EXPECT_EQ(mean.at(ComparedQuantity::arm_amplitudes), (std::vector{3.0, 20.0}));
}

TEST(QuantityNames, RoundTrip) {
  for (const ComparedQuantity quantity : all_values<ComparedQuantity>)
    EXPECT_EQ(value_named<ComparedQuantity>(to_text(quantity)), quantity);
  EXPECT_EQ(value_named<ComparedQuantity>("speed"), std::nullopt);
}

}  // namespace
}  // namespace beadswim
