#include "beadswim/coupling/refill.hpp"

#include <gtest/gtest.h>

#include <random>

namespace beadswim {
namespace {

/// A steady linear shear flow with the density 1 + r. All terms of higher order in the velocity are omitted.
struct ShearFlow {
  double density_deviation;
  Vec3 velocity;
  Eigen::Matrix3d shear;  ///< du_a/dx_b, without trace

  /// Returns the population f_i. `time` is the relaxation time tau before the collision, and tau - 1 after
  /// the collision.
  double population(int i, double time) const {
    const Vec3 c = velocity_of(i);
    return d3q19::weight(i) * (density_deviation + 3 * c.dot(velocity) - 3 * time * c.dot(shear * c));
  }
};

ShearFlow random_flow(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> rate(-1e-8, 1e-8);
  ShearFlow flow{.density_deviation = rate(random),
                 .velocity = Vec3(rate(random), rate(random), rate(random)),
                 .shear = Eigen::Matrix3d::NullaryExpr([&] { return rate(random); })};
  flow.shear -= Eigen::Matrix3d::Identity() * flow.shear.trace() / 3;
  return flow;
}

// A plane wall through the cell, so that what comes from one side of it is known: one of each pair, or both.
// Catches a pair counted twice or once, the wrong decay, a stress turned round.
TEST(Refill, IsExactInALinearShearFlow) {
  constexpr double squares = 1e-15;  // of velocities: the flow has none
  for (unsigned seed = 1; seed <= 50; ++seed) {
    const ShearFlow flow = random_flow(seed);
    const double tau = 0.6 + 0.05 * seed;
    const Vec3 out_of_wall = Vec3(0.3, -0.2 * (seed % 7), 1).normalized();
    Arrivals arrivals;
    for (int i = 1; i < d3q19::directions; ++i) {
      if (velocity_of(i).dot(out_of_wall) > 1e-9) continue;
      arrivals.is_known[i] = true;
      arrivals.population[i] = flow.population(i, tau);
    }
    const Eigen::Matrix3d stress = stress_of(arrivals, flow.density_deviation, flow.velocity);
    for (int i = 0; i < d3q19::directions; ++i) {
      EXPECT_NEAR(refilled(i, flow.density_deviation, flow.velocity, stress, 1 - 1 / tau),
                  flow.population(i, tau - 1), squares)
          << "direction " << i << ", tau " << tau;
    }
  }
}

}  // namespace
}  // namespace beadswim
