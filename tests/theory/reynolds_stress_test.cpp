#include "beadswim/theory/reynolds_stress.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>

#include "beadswim/theory/linear_response.hpp"
#include "lone_sphere_flow.hpp"
#include "space_integral.hpp"
#include "swimmers.hpp"

namespace beadswim {
namespace {

Eigen::Vector3d towing_of(const CollinearSwimmer& swimmer) {
  return towing_forces(rest_mobility(swimmer, rotne_prager).value);
}

/// Returns the integrand rho u_i u_j* : grad u^ at (x, s).
Eigen::Matrix3cd integrand(const CollinearSwimmer& swimmer, double rho, const Eigen::Vector3d& towing,
                           double x, double s) {
  const LinePositions center = rest_positions(swimmer);
  const std::complex<double> alpha = inverse_penetration_depth(swimmer, rho);
  Eigen::Matrix<std::complex<double>, 3, 2> u;
  Eigen::Matrix2d gradient = Eigen::Matrix2d::Zero();
  for (int i = 0; i < 3; ++i) {
    u.row(i) = oscillating_sphere_flow(swimmer.radius[i], swimmer.viscosity, alpha, x - center[i], s);
    gradient += towing[i] * towed_sphere_gradient(swimmer.radius[i], swimmer.viscosity, x - center[i], s);
  }
  return rho * u * (gradient + gradient.transpose()) / 2 * u.adjoint();
}

/// Returns the swimmer with a period for which the penetration depth in a fluid of density 1 is `depth`.
CollinearSwimmer with_depth(CollinearSwimmer swimmer, double depth) {
  swimmer.period = std::numbers::pi * depth * depth / swimmer.viscosity;
  return swimmer;
}

CollinearSwimmer near_beads() {
  CollinearSwimmer swimmer = paper_swimmer(2000);
  swimmer.arm = {10.4, 10.4};  // l = 2.6 lambda
  return swimmer;
}

double relative_difference(const Eigen::Matrix3cd& a, const Eigen::Matrix3cd& b) {
  return (a - b).cwiseAbs().maxCoeff() / b.cwiseAbs().maxCoeff();
}

// Nothing clever: points of a square lattice of the half-plane, each a ring. Catches wrong weights, a piece
// of space that is missing or counted twice, and wrong pairing of flow and gradient.
TEST(ReynoldsStress, IsTheSumOverRings) {
  constexpr double h = 0.25, reach = 100;
  constexpr double truncation = 1e-2;  // beads' surfaces between lattice points; beyond `reach` r^-5
  const CollinearSwimmer swimmer = with_depth(unequal_swimmer(), 8);
  const Eigen::Vector3d towing = towing_of(swimmer);
  Eigen::Matrix3cd sum = Eigen::Matrix3cd::Zero();
  for (double x = -reach + h / 2; x < reach; x += h) {
    for (double s = h / 2; s < reach; s += h) {
      sum += 2 * std::numbers::pi * s * h * h * integrand(swimmer, 1, towing, x, s);
    }
  }
  EXPECT_LT(relative_difference(reynolds_stress_form(swimmer, 1, towing).total, sum), truncation);
}

class ReynoldsStressAccuracy : public testing::TestWithParam<double> {};

// The header's claim, against a composite rule in other variables (itself converged to 1e-7).
TEST_P(ReynoldsStressAccuracy, IsAsStated) {
  constexpr double stated = 1e-5;
  for (const CollinearSwimmer& shape : {paper_swimmer(2000), unequal_swimmer(), near_beads()}) {
    const CollinearSwimmer swimmer = with_depth(shape, GetParam());
    const Eigen::Vector3d towing = towing_of(swimmer);
    const Eigen::Matrix3cd fine =
        integral_over_space(swimmer, 1e5 * (GetParam() + 20), 24,
                            [&](double x, double s) { return integrand(swimmer, 1, towing, x, s); });
    EXPECT_LT(relative_difference(reynolds_stress_form(swimmer, 1, towing).total, fine), stated)
        << "arms " << swimmer.arm[0] << " and " << swimmer.arm[1];
  }
}

INSTANTIATE_TEST_SUITE_P(Depths, ReynoldsStressAccuracy,
                         testing::Values(0.4, 2.0, 10.0, 30.0, 200.0, 6000.0, 20000.0));

TEST(ReynoldsStress, FormIsHermitian) {
  constexpr double roundoff = 1e-14;
  const CollinearSwimmer swimmer = unequal_swimmer();
  const Eigen::Matrix3cd form = reynolds_stress_form(swimmer, 1, towing_of(swimmer)).total;
  EXPECT_LT(relative_difference(form.adjoint(), form), roundoff);
}

// By symmetry a mirrored pair of forces moves nothing: Q changes sign with the order of equal beads.
TEST(ReynoldsStress, ChangesSignInTheMirror) {
  constexpr double stated = 1e-5;
  const CollinearSwimmer swimmer = paper_swimmer(2000);
  const Eigen::Matrix3cd form = reynolds_stress_form(swimmer, 1, towing_of(swimmer)).total;
  EXPECT_LT(relative_difference(-form.reverse(), form), stated);
}

}  // namespace
}  // namespace beadswim
