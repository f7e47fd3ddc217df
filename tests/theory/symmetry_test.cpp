#include <gtest/gtest.h>

#include "beadswim/theory/methods.hpp"
#include "swimmers.hpp"

// What no swimmer in Stokes flow may break, whatever the pair law.

namespace beadswim {
namespace {

constexpr double roundoff = 1e-12;  // relative

CollinearSwimmer mirrored(const CollinearSwimmer& s) {
  CollinearSwimmer m = s;
  std::swap(m.radius[0], m.radius[2]);
  std::swap(m.arm[0], m.arm[1]);
  std::swap(m.stiffness[0], m.stiffness[1]);
  std::swap(m.damping[0], m.damping[1]);
  std::swap(m.amplitude[0], m.amplitude[1]);
  m.phase = -s.phase;  // bead 1 is now driven by B sin(wt + alpha): time shifted, A lags by alpha
  return m;
}

/// The same swimmer in units `length`, `time`, `mass` times smaller.
CollinearSwimmer in_units(const CollinearSwimmer& s, double length, double time, double mass) {
  CollinearSwimmer u = s;
  for (double& radius : u.radius) radius *= length;
  for (double& arm : u.arm) arm *= length;
  for (double& stiffness : u.stiffness) stiffness *= mass / (time * time);
  for (double& damping : u.damping) damping *= mass / time;
  for (double& amplitude : u.amplitude) amplitude *= mass * length / (time * time);
  u.period *= time;
  u.viscosity *= mass / (length * time);
  return u;
}

class SwimmerSymmetry : public testing::TestWithParam<PairLaw> {};

TEST_P(SwimmerSymmetry, MirroredSwimmerMovesTheOtherWay) {
  const CollinearSwimmer swimmer = unequal_swimmer();
  const double forward = perturbation_velocity(swimmer, GetParam());
  EXPECT_NEAR(perturbation_velocity(mirrored(swimmer), GetParam()) / forward, -1, roundoff);
}

TEST_P(SwimmerSymmetry, OppositePhaseMovesEqualSwimmerTheOtherWay) {
  CollinearSwimmer swimmer = paper_swimmer(2000);
  const double forward = perturbation_velocity(swimmer, GetParam());
  swimmer.phase = -swimmer.phase;
  EXPECT_NEAR(perturbation_velocity(swimmer, GetParam()) / forward, -1, roundoff);
}

// Mirror-symmetric driving of a mirror-symmetric swimmer: its two arms change alike, one degree of freedom.
TEST_P(SwimmerSymmetry, DoesNotMoveWhenDrivenInPhaseOrInAntiphase) {
  for (const double phase : {0.0, std::numbers::pi}) {
    CollinearSwimmer swimmer = paper_swimmer(2000);
    const double scale = perturbation_velocity(swimmer, GetParam());
    swimmer.phase = phase;
    EXPECT_LT(std::abs(perturbation_velocity(swimmer, GetParam()) / scale), roundoff);
  }
}

// Scallop theorem: with one arm held by an all but rigid spring, a single degree of freedom is left.
TEST_P(SwimmerSymmetry, DoesNotMoveWithOneRigidArm) {
  CollinearSwimmer swimmer = unequal_swimmer();
  const double scale = perturbation_velocity(swimmer, GetParam());
  swimmer.stiffness[1] = 1e9;
  swimmer.damping[1] = 0;
  constexpr double truncation = 1e-7;  // the arm still yields by F/k
  EXPECT_LT(std::abs(perturbation_velocity(swimmer, GetParam()) / scale), truncation);
}

TEST_P(SwimmerSymmetry, VelocityIsQuadraticInTheDriving) {
  CollinearSwimmer swimmer = unequal_swimmer();
  const double velocity = perturbation_velocity(swimmer, GetParam());
  for (double& amplitude : swimmer.amplitude) amplitude *= -3;
  EXPECT_NEAR(perturbation_velocity(swimmer, GetParam()) / velocity, 9, 9 * roundoff);
}

TEST_P(SwimmerSymmetry, DoesNotDependOnUnits) {
  const double length = 1e-6 / 4, time = 3e-7, mass = 5e-15;
  const CollinearSwimmer swimmer = unequal_swimmer();
  const CollinearMobility mobility = rest_mobility(swimmer, GetParam());
  const SecondOrderMotion lattice = second_order_motion(swimmer, mobility);
  const CollinearSwimmer converted = in_units(swimmer, length, time, mass);
  const SecondOrderMotion si = second_order_motion(converted, rest_mobility(converted, GetParam()));
  EXPECT_NEAR(si.velocity / (lattice.velocity * length / time), 1, roundoff);
  EXPECT_NEAR(si.arm_changes[0] / (lattice.arm_changes[0] * length), 1, roundoff);
  EXPECT_NEAR(si.stroke.amplitude[1] / (lattice.stroke.amplitude[1] * length), 1, roundoff);
  EXPECT_NEAR(si.stroke.phase[1], lattice.stroke.phase[1], roundoff);
}

INSTANTIATE_TEST_SUITE_P(PairLaws, SwimmerSymmetry, testing::Values(oseen, rotne_prager),
                         [](const auto& info) { return info.index == 0 ? "Oseen" : "RotnePrager"; });

// Every method in the table, closed forms included, says the same whatever the units.
TEST(Methods, DoNotDependOnUnits) {
  const double length = 2.5, time = 40, mass = 0.01;
  const Question lattice{.swimmer = paper_swimmer(2000), .fluid_density = 1, .measured_stroke = {}};
  const Question other{.swimmer = in_units(lattice.swimmer, length, time, mass),
                       .fluid_density = mass / (length * length * length),
                       .measured_stroke = {}};
  for (const Method& method : methods()) {
    const Prediction a = predict(method, lattice), b = predict(method, other);
    EXPECT_NEAR(b.velocity / (a.velocity * length / time), 1, roundoff) << method.name;
    EXPECT_NEAR(*b.uncertainty, *a.uncertainty, roundoff) << method.name;
    EXPECT_EQ(b.validity, a.validity) << method.name;
  }
}

}  // namespace
}  // namespace beadswim
