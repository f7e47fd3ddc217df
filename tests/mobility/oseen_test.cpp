#include "beadswim/mobility/oseen.hpp"

#include <gtest/gtest.h>

#include "central_difference.hpp"

namespace beadswim {
namespace {

constexpr double eta = 1.0 / 3;  // [mass/(length time)]

// The field of a Stokeslet on its own axis is twice that beside it; a transverse law would give half of this.
TEST(Oseen, MovesSphereAtTwoRadiiWithThreeQuartersOfStokesVelocity) {
  constexpr double roundoff = 1e-15;
  const double radius = 4;
  EXPECT_NEAR(oseen(radius, radius, 2 * radius, eta).value / self_mobility(radius, eta), 0.75, roundoff);
}

// The spheres act as points: only a law with a finite-size term would see the radii.
TEST(Oseen, DoesNotDependOnRadii) {
  EXPECT_EQ(oseen(1, 5, 20, eta).value, oseen(3, 2, 20, eta).value);
}

TEST(Oseen, SlopeIsDerivativeOfValue) {
  constexpr double truncation = 1e-9;  // central difference of step 1e-5 r, relative
  for (const double r : {8.5, 20.0, 55.0}) {
    const double slope = central_difference(oseen, 4, 3, r, eta);
    EXPECT_NEAR(oseen(4, 3, r, eta).slope / slope, 1, truncation) << "r = " << r;
  }
}

}  // namespace
}  // namespace beadswim
