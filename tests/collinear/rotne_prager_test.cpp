#include "beadswim/collinear/rotne_prager.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <random>

#include "beadswim/collinear/collinear_mobility.hpp"
#include "beadswim/collinear/oseen.hpp"
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

TEST(RotnePrager, SlopeIsDerivativeOfValue) {
  constexpr double truncation = 2e-9;  // central difference of step 1e-5 r, relative
  for (const double r : {7.5, 20.0, 55.0}) {
    const double slope = central_difference(rotne_prager, 4, 3, r, eta);
    EXPECT_NEAR(rotne_prager(4, 3, r, eta).slope / slope, 1, truncation) << "r = " << r;
  }
}

/// Returns sin(x)/x: the mean of exp(ikz) over the surface of a sphere of radius a, x = ka.
double surface_mean(double x) {
  return x == 0 ? 1 : std::sin(x) / x;
}

/// Returns (1/2) int (1 - c^2) exp(ixc) dc over -1 < c < 1: the xx component of the Oseen tensor averaged
/// over all directions of k.
double oseen_direction_mean(double x) {
  return x < 1e-2 ? 2.0 / 3 - x * x / 15 : 2 * (std::sin(x) / x - std::cos(x)) / (x * x);
}

/// Returns the xx component of the Oseen tensor averaged over both surfaces, as an integral over k up to
/// `cutoff`: (1 / (2 pi^2 eta)) int dk surface_mean(k a_i) surface_mean(k a_j) oseen_direction_mean(k r). The
/// integrand is even and limited to the band a_i + a_j + r, so that the trapezoidal rule is exact.
double oseen_averaged_over_surfaces(double a_i, double a_j, double r, double cutoff) {
  const double step = 3 / (a_i + a_j + r);
  double sum = 0;
  for (double k = 0; k < cutoff; k += step) {
    const double term = surface_mean(k * a_i) * surface_mean(k * a_j) * oseen_direction_mean(k * r);
    sum += k == 0 ? term / 2 : term;
  }
  return sum * step / (2 * std::numbers::pi * std::numbers::pi * eta);
}

// The definition of the law, in every branch: apart, cutting, one within the other, concentric.
TEST(RotnePrager, IsOseenAveragedOverBothSurfaces) {
  constexpr double truncation =
      1e-9;  // relative: cut off at k a_j, k r >= 2000, where the rest falls as k^-3
  for (const double a_j : {4.0, 1.5, 0.4}) {
    for (const double r : {9.0, 8.0, 5.0, 4.2, 3.0, 1.0, 0.1}) {
      const double average = oseen_averaged_over_surfaces(4, a_j, r, 2000 / std::min(a_j, r));
      EXPECT_NEAR(rotne_prager(4, a_j, r, eta).value / average, 1, truncation)
          << "a_j = " << a_j << ", r = " << r;
    }
  }
}

TEST(RotnePrager, OverlappingIsSymmetricAndSlopeIsDerivative) {
  constexpr double truncation = 1e-8;  // central difference of step 1e-5 r, relative
  for (const double r : {3.5, 4.0, 4.9}) {
    EXPECT_EQ(rotne_prager(4, 1, r, eta).value, rotne_prager(1, 4, r, eta).value);
    const double slope = central_difference(rotne_prager, 4, 1, r, eta);
    EXPECT_NEAR(rotne_prager(1, 4, r, eta).slope / slope, 1, truncation) << "r = " << r;
  }
}

}  // namespace
}  // namespace beadswim
