#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "beadswim/core/complex.hpp"
#include "beadswim/theory/unsteady_multipole.hpp"
#include "outside_nodes.hpp"
#include "scenes.hpp"
#include "time_integration.hpp"

// Power of the driving and Lighthill efficiency of predictions.

namespace beadswim {
namespace {

/// Returns the mean power of the dashpots for the complex arm amplitudes `arm`.
double dissipation_in_dashpots(const CollinearSwimmer& swimmer, const Eigen::Vector2cd& arm) {
  const double omega = swimmer.angular_frequency();
  return omega * omega / 2 *
         (swimmer.damping[0] * std::norm(arm[0]) + swimmer.damping[1] * std::norm(arm[1]));
}

// At finite amplitude, against the work of the driving forces along an integrated motion.
TEST(Power, IsTheWorkOfTheDrivingForces) {
  constexpr double nine_digits = 1e-9;
  for (const CollinearSwimmer& swimmer :
       {with_amplitude(paper_swimmer(4800), 0.3), with_amplitude(unequal_swimmer(), 0.3)}) {
    const auto mobility = [&](timestepping::Real arm_1, timestepping::Real arm_2) -> timestepping::Matrix3 {
      const LinePositions x{-static_cast<double>(arm_1), 0, static_cast<double>(arm_2)};
      return pairwise_mobility(rotne_prager, swimmer.radius, x, swimmer.viscosity)
          .value.cast<timestepping::Real>();
    };
    const Prediction p = predicted("rpy-ode", ask(swimmer));
    timestepping::Vector2 arms;
    for (int i = 0; i < 2; ++i)
      arms[i] = (*p.arm_means)[i] + p.stroke.amplitude[i] * std::cos(p.stroke.phase[i]);
    const timestepping::Motion motion = timestepping::periodic(swimmer, mobility, arms, 48);
    EXPECT_NEAR(p.velocity / motion.velocity, 1, nine_digits);
    EXPECT_NEAR(*p.power / motion.power, 1, nine_digits);
  }
}

// With inertia of fluid and heavy beads the driving does the work that the fluid outside of the beads
// dissipates, which is an integral of its rate of strain, and the dashpots.
TEST(Power, IsDissipatedInFluidAndDashpots) {
  constexpr double quadrature = 1e-7;
  for (const double density : {1.0, 5.0}) {
    const CollinearSwimmer swimmer = with_density(unequal_swimmer(), density);
    const LinePositions positions = rest_positions(swimmer);
    const Complex alpha = inverse_penetration_depth(swimmer, 1);
    const OscillatingSpheres flow(swimmer.radius, positions, swimmer.viscosity, alpha, 10);
    const UnsteadyMultipoles exact = unsteady_multipoles(swimmer, 1, sufficient_resolution(swimmer).value());
    const LinearResponse response = linear_response(swimmer, exact.mobility);
    const Eigen::Vector3cd velocity = Complex(0, swimmer.angular_frequency()) * response.displacement;
    double dissipation = 0;
    for (const auto& [x, s, weight] :
         outside_nodes(swimmer.radius, positions, std::sqrt(2.0) / std::abs(alpha), 8)) {
      const FlowAtPoint at = flow.at(x, s);
      const Eigen::Vector4cd g = at.gradient * velocity;
      const Complex hoop = (at.velocity.row(1) * velocity).value() / s, shear = (g[1] + g[2]) / 2.0;
      const double square = std::norm(g[0]) + std::norm(g[3]) + std::norm(hoop) + 2 * std::norm(shear);
      dissipation += weight * swimmer.viscosity * square;  // 2 eta <e : e>
    }
    const Prediction p = predicted("unsteady-multipole", ask(swimmer));
    EXPECT_NEAR(*p.power / (dissipation + dissipation_in_dashpots(swimmer, response.arm)), 1, quadrature);
  }
}

// Lighthill's efficiency with the drag of another solution of steady flow; the swimmer of the paper is a poor
// one.
TEST(Power, GivesLighthillsEfficiency) {
  constexpr double truncation = 1e-8;
  const CollinearSwimmer swimmer = with_amplitude(unequal_swimmer(), 0.2);
  const Prediction p = predicted("multipole-ode", ask(swimmer));
  const std::array<double, 3> positions{-(*p.arm_means)[0], 0, (*p.arm_means)[1]};
  const double drag =
      OscillatingSpheres(swimmer.radius, positions, swimmer.viscosity, 0, 16).resistance().real().sum();
  EXPECT_NEAR(setting(p, "towing_drag") / drag, 1, truncation);
  EXPECT_NEAR(*p.efficiency / (drag * p.velocity * p.velocity / *p.power), 1, truncation);
  EXPECT_LT(*p.efficiency, 0.01);
}

TEST(Power, IsZeroAtRestAndAbsentForMeasuredStrokes) {
  const Prediction at_rest = predicted("rpy-perturbation", ask(with_amplitude(paper_swimmer(4800), 0)));
  EXPECT_EQ(*at_rest.power, 0);
  EXPECT_FALSE(at_rest.efficiency);
  Question measured = ask(paper_swimmer(4800));
  measured.measured_stroke = Stroke{.amplitude = {3.5, 5.5}, .phase = {1.0, -0.2}};
  EXPECT_FALSE(predicted("multipole-stroke", measured).power);
}

}  // namespace
}  // namespace beadswim
