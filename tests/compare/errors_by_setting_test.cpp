#include "beadswim/compare/errors_by_setting.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace beadswim {
namespace {

Results velocity_of(double value) {
  return {{ResultQuantity::velocity, {{value}}}, {ResultQuantity::sin_phase_shift, {{0}}}};
}

CostedRun run_of(const std::string& setting, double resolution, double cost, double velocity) {
  return {setting + ".json", setting, resolution, cost, {velocity_of(velocity)}};
}

TEST(ErrorsBySetting, AreOfAllRunsOfOneResolution) {
  const std::vector runs{run_of("mr", 4, 100, 1.01), run_of("cli", 3, 7, 1.5), run_of("mr", 2, 10, 1.03),
                         run_of("mr", 2, 30, 0.96), run_of("mr", 2, 20, 1)};
  const std::vector<Results> reference{{{ResultQuantity::velocity, {{1}}}}};
  const auto all = errors_by_setting(runs, reference);
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[0].setting, "mr");
  ASSERT_EQ(all[0].resolutions.size(), 2U);
  EXPECT_EQ(all[0].resolutions[0].resolution, 2);
  EXPECT_EQ(all[0].resolutions[0].cost, 20);
  EXPECT_NEAR(all[0].resolutions[0].errors.at(ResultQuantity::velocity), std::sqrt((9. + 16) / 3) / 100,
              1e-15);
  EXPECT_EQ(all[0].resolutions[0].errors.size(), 1U);  // what the reference knows
}

TEST(ErrorsBySetting, EachSwimmerHasItsOwnReference) {
  CostedRun run = run_of("mr", 4, 1, 2);
  run.swimmers.push_back(velocity_of(6));
  const std::vector<Results> one{velocity_of(2)}, each{velocity_of(2), velocity_of(6)};
  const auto error = [&](const std::vector<Results>& reference) {
    return errors_by_setting(std::span(&run, 1), reference)[0].resolutions[0].errors.at(
        ResultQuantity::velocity);
  };
  EXPECT_EQ(error(each), 0);
  EXPECT_DOUBLE_EQ(error(one), std::sqrt(2));
}

TEST(ErrorsBySetting, ASwimmerThatHardlyMovesDoesNotDominate) {
  CostedRun run = run_of("mr", 4, 1, 3.03);
  run.swimmers.push_back(velocity_of(0.04));
  const std::vector<Results> reference{velocity_of(3), velocity_of(0.01)};
  const auto all = errors_by_setting(std::span(&run, 1), reference);
  EXPECT_NEAR(all[0].resolutions[0].errors.at(ResultQuantity::velocity), 0.01 * std::sqrt(2), 1e-6);
}

}  // namespace
}  // namespace beadswim
