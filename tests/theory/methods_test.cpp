#include "beadswim/theory/methods.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "beadswim/core/error.hpp"
#include "beadswim/theory/closed_forms.hpp"
#include "swimmers.hpp"

namespace beadswim {
namespace {

/// Returns a question for a swimmer in a periodic box with a measured stroke, which all methods can answer.
Question ask_all(const CollinearSwimmer& swimmer) {
  Question asked = ask(swimmer);
  asked.surroundings.box =
      BoxPlace{.box = {.lengths = {160, 120, 120}, .boundary = {}}, .middle_bead = {80, 60, 60}};
  asked.measured_stroke = Stroke{.amplitude = {3.5, 5.5}, .phase = {1.0, -0.2}};
  return asked;
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
    EXPECT_THAT(error.what(), testing::HasSubstr("did you mean \"rpy-perturbation\""));
  }
}

TEST(Methods, ClosedFormsRefuseUnequalPartsAndSayWhy) {
  CollinearSwimmer swimmer = paper_swimmer(4800);
  swimmer.radius[2] = 5;
  EXPECT_THAT(refusal("oseen-force-closed", ask(swimmer)), testing::HasSubstr("radii 4, 4, 5 differ"));
  swimmer = paper_swimmer(4800);
  swimmer.arm[1] = 25;
  EXPECT_THAT(refusal("oseen-stroke-closed", ask(swimmer)), testing::HasSubstr("arm lengths 20, 25 differ"));
  swimmer = paper_swimmer(4800);
  swimmer.stiffness[1] = 0.1;
  EXPECT_THAT(refusal("oseen-force-closed", ask(swimmer)), testing::HasSubstr("stiffnesses"));
  swimmer = paper_swimmer(4800);
  swimmer.damping[0] = 1;
  EXPECT_THAT(refusal("oseen-stroke-closed", ask(swimmer)), testing::HasSubstr("neglects damping"));
}

TEST(Methods, AllOthersTreatUnequalParts) {
  for (const char* name :
       {"oseen-perturbation", "rpy-perturbation", "multipole-perturbation", "oseen-ode", "rpy-ode",
        "multipole-ode", "rpy-box-perturbation", "rpy-box-ode", "unsteady-response", "inertia-corrected"}) {
    CollinearSwimmer swimmer = unequal_swimmer();
    swimmer.amplitude = {0.2, 0.1};
    EXPECT_EQ(refusal(name, ask_all(swimmer)), "") << name;
  }
}

TEST(Methods, AllRefuseBeadsThatOverlap) {
  CollinearSwimmer swimmer = paper_swimmer(4800);
  swimmer.arm = {7.9, 7.9};
  for (const Method& method : methods()) {
    if (!method.obstacle_to_line) continue;  // for other shapes
    EXPECT_THAT(refusal(method.name, ask_all(swimmer)), testing::HasSubstr("overlap")) << method.name;
  }
}

// Two radii and a thousandth: beads apart, but the multipole series would need too many terms.
TEST(Methods, ThoseOfExactFlowRefuseBeadsThatAllButTouch) {
  CollinearSwimmer swimmer = paper_swimmer(4800);
  swimmer.arm = {8.004, 8.004};
  const Question asked = ask_all(swimmer);
  EXPECT_FALSE(asked.exact());
  for (const char* name : {"multipole-stroke", "multipole-perturbation", "multipole-ode"}) {
    EXPECT_THAT(refusal(name, asked), testing::HasSubstr("too close to its neighbour")) << name;
  }
  EXPECT_EQ(refusal("rpy-perturbation", asked), "");
  EXPECT_FALSE(predict(find_method("rpy-perturbation"), asked).uncertainty.has_value());
}

TEST(Methods, MultipoleStrokeAsksForAMeasuredStroke) {
  EXPECT_THAT(refusal("multipole-stroke", ask(paper_swimmer(4800))),
              testing::HasSubstr("give one with stroke record"));
}

TEST(Methods, AreFiniteWithOneOrBothForcesOff) {
  for (const std::array<double, 2>& amplitude : {std::array<double, 2>{0, 0.1}, {0.1, 0}, {0, 0}}) {
    CollinearSwimmer swimmer = paper_swimmer(4800);
    swimmer.amplitude = amplitude;
    for (const Method& method : methods()) {
      if (!obstacle(method, ask_all(swimmer)).empty()) continue;  // a formula for A = B
      const Prediction p = predict(method, ask_all(swimmer));
      const double sum = p.velocity + p.sin_phase_shift + p.uncertainty.value_or(0) + p.stroke.amplitude[0] +
                         p.stroke.amplitude[1] + p.stroke.phase[0] + p.stroke.phase[1];
      EXPECT_TRUE(std::isfinite(sum)) << method.name;
    }
  }
}

TEST(Methods, PredictNoMotionWithoutDriving) {
  CollinearSwimmer swimmer = paper_swimmer(4800);
  swimmer.amplitude = {0, 0};
  Question asked = ask_all(swimmer);
  asked.measured_stroke = Stroke{};  // what such a run would measure
  for (const Method& method : methods()) {
    if (!method.obstacle_to_line) continue;
    EXPECT_EQ(predict(method, asked).velocity, 0) << method.name;
  }
}

// (4.2) of a stroke given from outside, even for a swimmer whose own stroke has no closed form.
TEST(Methods, OseenStrokeClosedUsesAMeasuredStroke) {
  CollinearSwimmer swimmer = paper_swimmer(4800);
  swimmer.stiffness[1] = 0.1;
  Question asked = ask(swimmer);
  asked.measured_stroke = Stroke{.amplitude = {3.5, 5.5}, .phase = {1.0, -0.2}};
  const Prediction prediction = predict(find_method("oseen-stroke-closed"), asked);
  const double G = 7 * 4.0 / (24 * 20 * 20), omega = 2 * std::numbers::pi / 4800;
  constexpr double roundoff = 1e-14;
  EXPECT_NEAR(prediction.velocity / (G * 3.5 * 5.5 * omega * std::sin(1.2)), 1, roundoff);
  EXPECT_EQ(prediction.stroke.amplitude, asked.measured_stroke->amplitude);
}

// A driving that is ahead turns the arms' phases by as much, within (-pi, pi], and changes nothing else; a
// stroke that was measured has it in its phases.
TEST(Methods, TurnPhasesByTheDrivingsOffset) {
  CollinearSwimmer swimmer = paper_swimmer(4800);
  swimmer.amplitude = {0.2, 0.2};
  const Question asked = ask(swimmer);
  swimmer.phase_offset = 3;
  Question ahead = ask(swimmer);
  for (const char* name : {"oseen-force-closed", "rpy-perturbation", "multipole-ode", "inertia-corrected"}) {
    const Prediction usual = predict(find_method(name), asked), turned = predict(find_method(name), ahead);
    EXPECT_EQ(turned.velocity, usual.velocity);
    for (int arm = 0; arm < 2; ++arm) {
      const double turn = turned.stroke.phase[arm] - usual.stroke.phase[arm];
      EXPECT_NEAR(std::remainder(turn - 3, 2 * std::numbers::pi), 0, 1e-12) << name;
      EXPECT_LE(std::abs(turned.stroke.phase[arm]), std::numbers::pi);
    }
  }
  ahead.measured_stroke = Stroke{.amplitude = {3.5, 5.5}, .phase = {1.0, -0.2}};
  EXPECT_EQ(predict(find_method("oseen-stroke-closed"), ahead).stroke.phase, ahead.measured_stroke->phase);
  Question usual_and_measured = asked;  // by a method that has no use for it
  usual_and_measured.measured_stroke = ahead.measured_stroke;
  const double turn = predict(find_method("rpy-perturbation"), ahead).stroke.phase[0] -
                      predict(find_method("rpy-perturbation"), usual_and_measured).stroke.phase[0];
  EXPECT_NEAR(std::remainder(turn - 3, 2 * std::numbers::pi), 0, 1e-12);
}

// Of the driven stroke given as measured, exact flow has its own velocity.
TEST(Methods, MultipoleStrokeIsTheExactVelocityOfTheStroke) {
  constexpr double roundoff = 1e-12;
  for (const CollinearSwimmer& swimmer : {paper_swimmer(4800), unequal_swimmer()}) {
    Question asked = ask(swimmer);
    asked.measured_stroke = asked.exact()->motion.stroke;
    const Prediction prediction = predict(find_method("multipole-stroke"), asked);
    EXPECT_NEAR(prediction.velocity / asked.exact()->motion.velocity, 1, roundoff);
    EXPECT_THAT(prediction.validity, testing::StartsWith("exact Stokes flow of three spheres"));
    EXPECT_THAT(prediction.validity, testing::Not(testing::HasSubstr("above")));
  }
}

// Known distances from exact Stokes flow at l = 5 lambda, T = 4800, small amplitude: 15.9, 23.4 and 11.8 %.
TEST(Methods, UncertaintyIsTheKnownDistanceFromExactStokesFlow) {
  CollinearSwimmer swimmer = paper_swimmer(4800);
  swimmer.amplitude = {1e-3, 1e-3};
  constexpr double printed_digits = 1e-3;
  EXPECT_NEAR(*predict(find_method("oseen-force-closed"), ask(swimmer)).uncertainty, 0.159, printed_digits);
  EXPECT_NEAR(*predict(find_method("oseen-perturbation"), ask(swimmer)).uncertainty, 0.234, printed_digits);
  EXPECT_NEAR(*predict(find_method("rpy-perturbation"), ask(swimmer)).uncertainty, 0.118, printed_digits);
}

// Below l/lambda 3 the multipoles still say.
TEST(Methods, UncertaintyIsTheDistanceFromMultipolesForNearBeadsToo) {
  CollinearSwimmer swimmer = paper_swimmer(4800);
  swimmer.arm = {9, 9};
  swimmer.amplitude = {1e-3, 1e-3};
  const double rotne_prager = prediction_of("rpy-perturbation", swimmer).velocity;
  const double exact = prediction_of("multipole-perturbation", swimmer).velocity;
  constexpr double amplitude_squared = 1e-6;
  EXPECT_NEAR(*prediction_of("rpy-perturbation", swimmer).uncertainty, rotne_prager / exact - 1,
              amplitude_squared);
}

// At small amplitude and large: distance from exact flow, and what second order leaves out, as squares.
TEST(Methods, UncertaintyOfSecondOrderGrowsWithAmplitude) {
  CollinearSwimmer swimmer = paper_swimmer(4800);
  swimmer.amplitude = {0.2, 0.2};
  const double change = ask(swimmer).exact()->amplitude_change;
  const Prediction pairs = prediction_of("rpy-perturbation", swimmer);
  const double distance = pairs.velocity / prediction_of("multipole-perturbation", swimmer).velocity - 1;
  constexpr double roundoff = 1e-12;
  EXPECT_NEAR(*pairs.uncertainty, std::hypot(distance, change), roundoff);
  EXPECT_NEAR(*prediction_of("rpy-ode", swimmer).uncertainty, distance, roundoff);
  EXPECT_EQ(*prediction_of("multipole-perturbation", swimmer).uncertainty, std::abs(change));
}

TEST(Methods, UncertaintyIsUnknownForNoMotion) {
  CollinearSwimmer swimmer = paper_swimmer(4800);
  swimmer.amplitude = {0.1, 0.1};
  swimmer.phase = 0;
  for (const char* name : {"oseen-force-closed", "rpy-perturbation", "multipole-perturbation", "rpy-ode"}) {
    EXPECT_FALSE(prediction_of(name, swimmer).uncertainty.has_value()) << name;
  }
}

// Gaps of 12 between the beads' surfaces; arm 2 swings by 26.7 A.
TEST(Methods, AreUnusableWhenTheStrokeWouldMakeBeadsCollide) {
  CollinearSwimmer swimmer = paper_swimmer(4800);
  swimmer.amplitude = {0.5, 0.5};
  EXPECT_FALSE(prediction_of("rpy-perturbation", swimmer).usable);
  swimmer.amplitude = {0.4, 0.4};
  EXPECT_TRUE(prediction_of("rpy-perturbation", swimmer).usable);
}

TEST(Methods, AtFiniteAmplitudeRefuseContactWithNumbers) {
  CollinearSwimmer swimmer = paper_swimmer(4800);
  swimmer.amplitude = {2, 2};
  for (const char* name : {"oseen-ode", "rpy-ode", "multipole-ode"}) {
    EXPECT_THAT(refusal(name, ask(swimmer)), testing::ContainsRegex("exceeds about 0\\.[0-9]+")) << name;
  }
}

TEST(Methods, AtFiniteAmplitudeSayWhatTheyAssumed) {
  CollinearSwimmer swimmer = paper_swimmer(4800);
  swimmer.amplitude = {0.2, 0.2};
  const Prediction prediction = prediction_of("rpy-ode", swimmer);
  EXPECT_THAT(prediction.settings,
              testing::Contains(testing::Pair("fluid", testing::VariantWith<std::string>("unbounded"))));
  EXPECT_THAT(prediction.settings,
              testing::Contains(testing::Pair("period", testing::VariantWith<double>(4800))));
}

}  // namespace
}  // namespace beadswim
