#include "beadswim/theory/methods.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "beadswim/core/error.hpp"
#include "beadswim/theory/closed_forms.hpp"
#include "swimmers.hpp"

namespace beadswim {
namespace {

Question question(const CollinearSwimmer& swimmer) {
  return {.swimmer = swimmer, .fluid_density = 1, .measured_stroke = {}};
}

std::string refusal(const std::string& method, const Question& asked) {
  try {
    predict(find_method(method), asked);
    return "";
  } catch (const InputError& error) {
    return error.what();
  }
}

TEST(Methods, UnknownNameIsRefusedWithTheNearest) {
  try {
    find_method("rpy-pertubation");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("did you mean 'rpy-perturbation'"));
  }
}

TEST(Methods, ClosedFormsRefuseUnequalPartsAndSayWhy) {
  CollinearSwimmer swimmer = paper_swimmer(4800);
  swimmer.radius[2] = 5;
  EXPECT_THAT(refusal("oseen-force-closed", question(swimmer)), testing::HasSubstr("radii 4, 4, 5 differ"));
  swimmer = paper_swimmer(4800);
  swimmer.arm[1] = 25;
  EXPECT_THAT(refusal("oseen-stroke-closed", question(swimmer)), testing::HasSubstr("arms 20, 25 differ"));
  swimmer = paper_swimmer(4800);
  swimmer.stiffness[1] = 0.1;
  EXPECT_THAT(refusal("oseen-force-closed", question(swimmer)), testing::HasSubstr("stiffnesses"));
  swimmer = paper_swimmer(4800);
  swimmer.damping[0] = 1;
  EXPECT_THAT(refusal("oseen-stroke-closed", question(swimmer)), testing::HasSubstr("dampers"));
}

TEST(Methods, PerturbationsTreatUnequalParts) {
  for (const char* name : {"oseen-perturbation", "rpy-perturbation"}) {
    EXPECT_EQ(refusal(name, question(unequal_swimmer())), "") << name;
  }
}

TEST(Methods, AllRefuseBeadsThatOverlap) {
  CollinearSwimmer swimmer = paper_swimmer(4800);
  swimmer.arm = {7.9, 7.9};
  for (const Method& method : methods()) {
    EXPECT_THAT(refusal(method.name, question(swimmer)), testing::HasSubstr("overlap")) << method.name;
  }
}

TEST(Methods, AreFiniteWithOneOrBothForcesOff) {
  for (const std::array<double, 2>& amplitude : {std::array<double, 2>{0, 1}, {1, 0}, {0, 0}}) {
    CollinearSwimmer swimmer = paper_swimmer(4800);
    swimmer.amplitude = amplitude;
    for (const Method& method : methods()) {
      const Prediction p = predict(method, question(swimmer));
      const double sum = p.velocity + p.sin_phase_shift + p.uncertainty.value_or(0) + p.stroke.amplitude[0] +
                         p.stroke.amplitude[1] + p.stroke.phase[0] + p.stroke.phase[1];
      EXPECT_TRUE(std::isfinite(sum)) << method.name;
    }
  }
}

TEST(Methods, PredictNoMotionWithoutDriving) {
  CollinearSwimmer swimmer = paper_swimmer(4800);
  swimmer.amplitude = {0, 0};
  for (const Method& method : methods()) {
    EXPECT_EQ(predict(method, question(swimmer)).velocity, 0) << method.name;
  }
}

// (4.2) of a stroke given from outside, even for a swimmer whose own stroke has no closed form.
TEST(Methods, OseenStrokeClosedUsesAMeasuredStroke) {
  Question asked = question(paper_swimmer(4800));
  asked.swimmer.stiffness[1] = 0.1;
  asked.measured_stroke = Stroke{.amplitude = {3.5, 5.5}, .phase = {1.0, -0.2}};
  const Prediction prediction = predict(find_method("oseen-stroke-closed"), asked);
  const double G = 7 * 4.0 / (24 * 20 * 20), omega = 2 * std::numbers::pi / 4800;
  constexpr double roundoff = 1e-14;
  EXPECT_NEAR(prediction.velocity / (G * 3.5 * 5.5 * omega * std::sin(1.2)), 1, roundoff);
  EXPECT_EQ(prediction.stroke.amplitude, asked.measured_stroke->amplitude);
}

// Known distances from exact Stokes flow at l = 5 lambda, T = 4800, small amplitude: 15.9, 23.4 and 11.8 %.
TEST(Methods, UncertaintyIsTheKnownDistanceFromExactStokesFlow) {
  CollinearSwimmer swimmer = paper_swimmer(4800);
  swimmer.amplitude = {1e-3, 1e-3};
  constexpr double printed_digits = 1e-3;
  EXPECT_NEAR(*predict(find_method("oseen-force-closed"), question(swimmer)).uncertainty, 0.159,
              printed_digits);
  EXPECT_NEAR(*predict(find_method("oseen-perturbation"), question(swimmer)).uncertainty, 0.234,
              printed_digits);
  EXPECT_NEAR(*predict(find_method("rpy-perturbation"), question(swimmer)).uncertainty, 0.118,
              printed_digits);
}

TEST(Methods, UncertaintyIsUnknownForNearBeadsAndForNoMotion) {
  CollinearSwimmer swimmer = paper_swimmer(4800);
  swimmer.arm = {11, 11};
  EXPECT_FALSE(predict(find_method("rpy-perturbation"), question(swimmer)).uncertainty.has_value());
  swimmer = paper_swimmer(4800);
  swimmer.phase = 0;
  EXPECT_FALSE(predict(find_method("rpy-perturbation"), question(swimmer)).uncertainty.has_value());
}

// Gaps of 12 between the beads' surfaces; arm 2 swings by 26.7 A.
TEST(Methods, AreUnusableWhenTheStrokeWouldMakeBeadsCollide) {
  CollinearSwimmer swimmer = paper_swimmer(4800);
  swimmer.amplitude = {0.5, 0.5};
  EXPECT_FALSE(predict(find_method("rpy-perturbation"), question(swimmer)).usable);
  swimmer.amplitude = {0.4, 0.4};
  EXPECT_TRUE(predict(find_method("rpy-perturbation"), question(swimmer)).usable);
}

}  // namespace
}  // namespace beadswim
