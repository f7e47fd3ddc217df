#include <gtest/gtest.h>

#include <algorithm>

#include "beadswim/theory/methods.hpp"
#include "swimmers.hpp"

// Tests of symmetries that hold for every swimmer in Stokes flow at finite amplitude, for every pair mobility.

namespace beadswim {
namespace {

class FiniteAmplitudeSymmetry : public testing::TestWithParam<const char*> {
 protected:
  static double velocity_of(const CollinearSwimmer& s) { return prediction_of(GetParam(), s).velocity; }
  /// Returns omega d, the speed of a bead.
  static double bead_speed(const CollinearSwimmer& s) {
    const Stroke stroke = prediction_of(GetParam(), s).stroke;
    return s.angular_frequency() * std::max(stroke.amplitude[0], stroke.amplitude[1]);
  }
};

constexpr double cycle_roundoff = 1e-13;  // of a bead's speed
constexpr double nine_digits = 1e-9;

CollinearSwimmer strongly_driven(CollinearSwimmer s) {
  s.amplitude = {0.3, 0.3};
  return s;
}

TEST_P(FiniteAmplitudeSymmetry, MirroredSwimmerMovesTheOtherWay) {
  CollinearSwimmer s = unequal_swimmer();
  s.amplitude = {0.3, 0.2};
  EXPECT_NEAR(velocity_of(mirrored(s)) / velocity_of(s), -1, nine_digits);
}

TEST_P(FiniteAmplitudeSymmetry, OppositePhaseMovesEqualSwimmerTheOtherWay) {
  CollinearSwimmer s = strongly_driven(paper_swimmer(4800));
  s.phase = 0.7;
  const double forward = velocity_of(s);
  s.phase = -0.7;
  EXPECT_NEAR(velocity_of(s) / forward, -1, nine_digits);
}

TEST_P(FiniteAmplitudeSymmetry, DoesNotMoveWhenDrivenInPhaseOrInAntiphase) {
  for (const double phase : {0.0, std::numbers::pi}) {
    CollinearSwimmer s = strongly_driven(paper_swimmer(4800));
    s.phase = phase;
    EXPECT_LT(std::abs(velocity_of(s)), cycle_roundoff * bead_speed(s));
  }
}

// Scallop theorem at 20 % of the gap: one arm held, all but rigid.
TEST_P(FiniteAmplitudeSymmetry, DoesNotMoveWithOneRigidArm) {
  CollinearSwimmer s = unequal_swimmer();
  s.amplitude = {0.3, 0.2};
  s.stiffness[1] = 1e9;
  s.damping[1] = 0;
  constexpr double truncation = 1e-9;  // of the bead's speed: the arm still yields by F/k
  EXPECT_LT(std::abs(velocity_of(s)), truncation * bead_speed(s));
}

// Half a period later and with all forces reversed: the same motion.
TEST_P(FiniteAmplitudeSymmetry, ReversedForcesMoveItTheSameWay) {
  CollinearSwimmer s = strongly_driven(unequal_swimmer());
  const double forward = velocity_of(s);
  for (double& amplitude : s.amplitude) amplitude *= -1;
  EXPECT_NEAR(velocity_of(s) / forward, 1, nine_digits);
}

INSTANTIATE_TEST_SUITE_P(Methods, FiniteAmplitudeSymmetry,
                         testing::Values("oseen-ode", "rpy-ode", "multipole-ode"), [](const auto& info) {
                           std::string name = info.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

/// Returns swimmer, box, fluid and stroke in other units: the units are smaller by the factors `length`,
/// `time` and `mass`.
Question in_units(Question q, double length, double time, double mass) {
  q.swimmer = in_units(q.swimmer, length, time, mass);
  q.fluid_density *= mass / (length * length * length);
  for (double& side : q.box->box.lengths) side *= length;
  for (double& place : q.box->middle_bead) place *= length;
  for (double& swing : q.measured_stroke->amplitude) swing *= length;
  return with_exact_reference(q);
}

// Every method in the table says the same whatever the units: in a box, with and without a measured stroke.
TEST(Methods, DoNotDependOnUnits) {
  constexpr double length = 2.5, time = 40, mass = 0.01;
  constexpr double resolved = 1e-9;  // relative: of iterations that end at a tolerance
  Question lattice = ask(paper_swimmer(2000));
  lattice.swimmer.amplitude = {0.2, 0.2};
  lattice.box = BoxPlace{.box = {.lengths = {128, 80, 80},
                                 .boundary = {Boundary::periodic, Boundary::periodic, Boundary::periodic}},
                         .middle_bead = {64, 40, 40}};
  lattice.measured_stroke = Stroke{.amplitude = {2.5, 3.6}, .phase = {1.0, 0.2}};
  lattice = with_exact_reference(lattice);
  const Question other = in_units(lattice, length, time, mass);
  for (const Method& method : methods()) {
    const Prediction a = predict(method, lattice), b = predict(method, other);
    EXPECT_NEAR(b.velocity / (a.velocity * length / time), 1, resolved) << method.name;
    EXPECT_NEAR(*b.uncertainty, *a.uncertainty, resolved) << method.name;
    EXPECT_NEAR(b.stroke.amplitude[0] / (a.stroke.amplitude[0] * length), 1, resolved) << method.name;
    EXPECT_EQ(b.validity, a.validity) << method.name;
    EXPECT_EQ(b.usable, a.usable) << method.name;
  }
}

}  // namespace
}  // namespace beadswim
