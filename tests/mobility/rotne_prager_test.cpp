#include "beadswim/mobility/rotne_prager.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>

#include "beadswim/mobility/collinear_mobility.hpp"
#include "beadswim/mobility/oseen.hpp"
#include "central_difference.hpp"

namespace beadswim {
namespace {

constexpr double eta = 1.0 / 3;  // [mass/(length time)]

// Equal spheres, in units of 1/(6 pi eta a), at s = distance/radius: 3/(2s) - 1/s^3. Catches a wrong size
// term.
TEST(RotnePrager, GivesTabulatedPairMobilityOfEqualSpheres) {
  constexpr double printed_digits = 0.5e-6;
  const double a = 4;
  const auto x12 = [&](double s) { return rotne_prager(a, a, s * a, eta).value / self_mobility(a, eta); };
  EXPECT_NEAR(x12(3), 0.462963, printed_digits);
  EXPECT_NEAR(x12(4), 0.359375, printed_digits);
  EXPECT_NEAR(x12(5), 0.292000, printed_digits);
}

// Exact two-sphere mobilities of Stokes flow at s = 3, 4, 5. A size term of wrong sign is off by 16 % at s
// = 3.
TEST(RotnePrager, IsNearerToExactStokesFlowThanOseen) {
  const double a = 4;
  const struct {
    double s, exact, model;
  } rows[] = {
      {3, 0.470760, 0.02}, {4, 0.360471, 0.004}, {5, 0.292234, 0.001}};  // model: relative, of order s^-6
  for (const auto& row : rows) {
    const double unit = self_mobility(a, eta);
    const double rp_error = std::abs(rotne_prager(a, a, row.s * a, eta).value / unit - row.exact) / row.exact;
    const double oseen_error = std::abs(oseen(a, a, row.s * a, eta).value / unit - row.exact) / row.exact;
    EXPECT_LT(rp_error, row.model) << "s = " << row.s;
    EXPECT_LT(rp_error, oseen_error) << "s = " << row.s;
  }
}

// The finite-size term falls as the square of radius over distance: three distances, slope 2.
TEST(RotnePrager, ApproachesOseenAsInverseSquareOfDistance) {
  const auto difference = [](double r) {
    return 1 - rotne_prager(4, 2, r, eta).value / oseen(4, 2, r, eta).value;
  };
  constexpr double roundoff = 1e-9;
  EXPECT_NEAR(std::log2(difference(40) / difference(80)), 2, roundoff);
  EXPECT_NEAR(std::log2(difference(80) / difference(160)), 2, roundoff);
  EXPECT_LT(difference(160), 3e-4);
}

// Faxen's law on a point force: velocity of sphere j (its surface mean) in the flow of a point at i is
// (1 + a_j^2/6 laplacian) of the Stokeslet's axial field; so the law is not the mean radius squared.
TEST(RotnePrager, ReducesToFaxenForAPointAndASphere) {
  constexpr double roundoff = 1e-15;
  const double radius = 5, r = 12;
  const double stokeslet = 1 / (4 * std::numbers::pi * eta * r);
  const double laplacian =
      -1 / (2 * std::numbers::pi * eta * r * r * r);  // of (I + rr)/(8 pi eta r), along the axis
  EXPECT_NEAR(rotne_prager(0, radius, r, eta).value, stokeslet + radius * radius / 6 * laplacian, roundoff);
}

TEST(RotnePrager, IsSymmetricInTheTwoSpheres) {
  EXPECT_EQ(rotne_prager(4, 1, 9, eta).value, rotne_prager(1, 4, 9, eta).value);
  EXPECT_EQ(rotne_prager(4, 1, 9, eta).slope, rotne_prager(1, 4, 9, eta).slope);
}

TEST(RotnePrager, SlopeIsDerivativeOfValue) {
  constexpr double truncation = 2e-9;  // central difference of step 1e-5 r, relative
  for (const double r : {7.5, 20.0, 55.0}) {
    const double slope = central_difference(rotne_prager, 4, 3, r, eta);
    EXPECT_NEAR(rotne_prager(4, 3, r, eta).slope / slope, 1, truncation) << "r = " << r;
  }
}

// Dissipation is positive for any forces on spheres that do not overlap, touching ones included.
TEST(RotnePrager, DissipatesForTouchingSpheresOfAnyRadii) {
  for (const double small : {1.0, 0.1, 0.01}) {
    for (const std::array<double, 3>& radii :
         {std::array<double, 3>{1, small, 1}, {small, 1, small}, {1, 1, small}}) {
      const std::array<double, 2> arms{radii[0] + radii[1], radii[1] + radii[2]};
      const Eigen::Matrix3d mobility = pairwise_mobility(rotne_prager, radii, arms, eta).value;
      EXPECT_GT(mobility.selfadjointView<Eigen::Lower>().eigenvalues().minCoeff(), 0) << "small = " << small;
    }
  }
}

}  // namespace
}  // namespace beadswim
