#include "beadswim/mobility/collinear_mobility.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "beadswim/mobility/rotne_prager.hpp"

namespace beadswim {
namespace {

constexpr double eta = 1.0 / 3;  // [mass/(length time)]
constexpr std::array<double, 3> radii{4, 3, 5};
constexpr LinePositions positions{-20, 0, 26};

Eigen::Matrix3d mobility_at(const LinePositions& x) {
  return pairwise_mobility(rotne_prager, radii, x, eta).value;
}

// (4.15), first row, in its right form: F1/a1 + (3/(2 L1) - (a1^2+a2^2)/(2 L1^3)) F2 + the same of L1+L2 for
// F3.
TEST(CollinearMobility, FirstBeadFollowsEquationOfMotion) {
  constexpr double roundoff = 1e-16;
  const auto pair = [](double a2_sum, double r) { return 3 / (2 * r) - a2_sum / (2 * r * r * r); };
  const double unit = 1 / (6 * std::numbers::pi * eta);
  const Eigen::Matrix3d mobility = mobility_at(positions);
  EXPECT_NEAR(mobility(0, 0), unit / 4, roundoff);
  EXPECT_NEAR(mobility(0, 1), unit * pair(16 + 9, 20), roundoff);
  EXPECT_NEAR(mobility(0, 2), unit * pair(16 + 25, 46), roundoff);
}

TEST(CollinearMobility, IsSymmetric) {
  const Eigen::Matrix3d mobility = mobility_at(positions);
  EXPECT_EQ(mobility, mobility.transpose());
}

// Catches an outer pair that follows one neighbour only, and a slope of the wrong sign.
TEST(CollinearMobility, SlopesAreDerivativesByEachPosition) {
  constexpr double truncation = 1e-12;  // absolute, central difference of step 1e-4 on entries of 1e-2
  const double step = 1e-4;
  const CollinearMobility mobility = pairwise_mobility(rotne_prager, radii, positions, eta);
  for (int k = 0; k < 3; ++k) {
    LinePositions ahead = positions, behind = positions;
    ahead[k] += step;
    behind[k] -= step;
    const Eigen::Matrix3d difference = (mobility_at(ahead) - mobility_at(behind)) / (2 * step);
    EXPECT_LT((mobility.slope[k] - difference).cwiseAbs().maxCoeff(), truncation) << k;
  }
}

}  // namespace
}  // namespace beadswim
