#include "beadswim/mobility/collinear_mobility.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "beadswim/mobility/rotne_prager.hpp"

namespace beadswim {
namespace {

constexpr double eta = 1.0 / 3;  // [mass/(length time)]
constexpr std::array<double, 3> radii{4, 3, 5};
constexpr std::array<double, 2> arms{20, 26};

Eigen::Matrix3d mobility_at(double arm_1, double arm_2) {
  return pairwise_mobility(rotne_prager, radii, {arm_1, arm_2}, eta).value;
}

// (4.15), first row, in its right form: F1/a1 + (3/(2 L1) - (a1^2+a2^2)/(2 L1^3)) F2 + the same of L1+L2 for
// F3.
TEST(CollinearMobility, FirstBeadFollowsEquationOfMotion) {
  constexpr double roundoff = 1e-16;
  const auto pair = [](double a2_sum, double r) { return 3 / (2 * r) - a2_sum / (2 * r * r * r); };
  const double unit = 1 / (6 * std::numbers::pi * eta);
  const Eigen::Matrix3d mobility = mobility_at(arms[0], arms[1]);
  EXPECT_NEAR(mobility(0, 0), unit / 4, roundoff);
  EXPECT_NEAR(mobility(0, 1), unit * pair(16 + 9, 20), roundoff);
  EXPECT_NEAR(mobility(0, 2), unit * pair(16 + 25, 46), roundoff);
}

TEST(CollinearMobility, IsSymmetric) {
  const Eigen::Matrix3d mobility = mobility_at(arms[0], arms[1]);
  EXPECT_EQ(mobility, mobility.transpose());
}

// Catches an outer pair that follows one arm only.
TEST(CollinearMobility, SlopesAreDerivativesByEachArm) {
  constexpr double truncation = 1e-12;  // absolute, central difference of step 1e-4 on entries of 1e-2
  const double step = 1e-4;
  const CollinearMobility mobility = pairwise_mobility(rotne_prager, radii, arms, eta);
  const Eigen::Matrix3d by_arm_1 = (mobility_at(20 + step, 26) - mobility_at(20 - step, 26)) / (2 * step);
  const Eigen::Matrix3d by_arm_2 = (mobility_at(20, 26 + step) - mobility_at(20, 26 - step)) / (2 * step);
  EXPECT_LT((mobility.slope[0] - by_arm_1).cwiseAbs().maxCoeff(), truncation);
  EXPECT_LT((mobility.slope[1] - by_arm_2).cwiseAbs().maxCoeff(), truncation);
}

}  // namespace
}  // namespace beadswim
