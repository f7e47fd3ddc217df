#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "beadswim/core/error.hpp"
#include "beadswim/theory/inertial_motion.hpp"
#include "scenes.hpp"

// Tests of the methods with inertia through the interface that users have.

namespace beadswim {
namespace {

constexpr double pi = std::numbers::pi;

// ---- Against an independent calculation

double reynolds_within_beads(const CollinearSwimmer& swimmer) {
  const InertialScene scene = unbounded_scene(ask(swimmer));
  const LinearResponse response = linear_response(swimmer, unsteady_mobility(scene));
  return reynolds_stress_velocity(reynolds_form(scene).inside, induced_forces(scene, response));
}

// Unsteady Faxen pairs, all in closed form from another derivation (own code in another language); Reynolds
// stress over all space by quadrature in shells and midway planes. Six digits of strokes, five to six of
// velocities.
TEST(UnsteadyResponse, IsThatOfAnIndependentCalculation) {
  const struct {
    double period, drift, reynolds, within_beads, d1, d2, sine;
  } rows[] = {{1000, 0.885983e-3, 2.112163e-5, -1.511761e-5, 7.75617, 9.77067, 0.64241},
              {2000, 1.758445e-3, -1.872389e-5, -1.825755e-5, 12.31363, 18.41980, 0.74284},
              {4800, 2.053306e-3, -1.832705e-5, -0.780071e-5, 17.58070, 28.24376, 0.95023},
              {10000, 1.431063e-3, -0.417378e-5, -0.153969e-5, 23.02314, 30.82847, 0.99650}};
  constexpr double last_digit = 0.51;   // of the numbers above
  constexpr double quadrature = 2e-10;  // 1e-5 of the Reynolds stress
  for (const auto& row : rows) {
    SCOPED_TRACE(row.period);
    const Prediction p = predicted("unsteady-response", ask(paper_swimmer(row.period)));
    EXPECT_NEAR(setting(p, "velocity_by_drift"), row.drift, last_digit * 1e-9);
    EXPECT_NEAR(setting(p, "velocity_by_reynolds_stress"), row.reynolds, quadrature);
    EXPECT_NEAR(p.velocity, row.drift + row.reynolds, last_digit * 1e-9 + quadrature);
    EXPECT_NEAR(reynolds_within_beads(paper_swimmer(row.period)), row.within_beads, quadrature);
    EXPECT_NEAR(p.stroke.amplitude[0], row.d1, last_digit * 1e-5);
    EXPECT_NEAR(p.stroke.amplitude[1], row.d2, last_digit * 1e-5);
    EXPECT_NEAR(p.sin_phase_shift, row.sine, last_digit * 1e-5);
  }
}

// The same in the periodic box 128 x 80 x 80, by another way of summing: the harmonic part by Ewald's method
// with a splitting of its own, the decaying one image by image. Reynolds stress without images in both.
TEST(UnsteadyResponse, InABoxIsThatOfAnIndependentCalculation) {
  const struct {
    double period, drift;
  } rows[] = {{1000, 0.885183e-3}, {2000, 1.758146e-3}, {4800, 2.033278e-3}, {10000, 1.428932e-3}};
  constexpr double last_digit = 0.51;
  const auto boxed = [](double period) {
    return predicted("unsteady-response", ask_in_box(paper_swimmer(period), periodic_box(128, 80, 80)));
  };
  for (const auto& row : rows)
    EXPECT_NEAR(setting(boxed(row.period), "velocity_by_drift"), row.drift, last_digit * 1e-9);
  EXPECT_NEAR(boxed(2000).stroke.amplitude[0], 12.35054, last_digit * 1e-5);
  EXPECT_NEAR(boxed(2000).stroke.amplitude[1], 18.36341, last_digit * 1e-5);
  EXPECT_NEAR(boxed(2000).sin_phase_shift, 0.74255, last_digit * 1e-5);
  EXPECT_NEAR(boxed(4800).stroke.amplitude[0], 17.57178, last_digit * 1e-5);
  EXPECT_NEAR(boxed(4800).stroke.amplitude[1], 28.01253, last_digit * 1e-5);
  EXPECT_NEAR(boxed(4800).sin_phase_shift, 0.94570, last_digit * 1e-5);
}

// ---- Symmetries

class InertialMethod : public testing::TestWithParam<std::string> {
 protected:
  double velocity(const Question& question) const { return predicted(GetParam(), question).velocity; }
};

CollinearSwimmer unequal_heavy_and_light() {
  CollinearSwimmer swimmer = with_amplitude(unequal_swimmer(), 0.2);
  swimmer.density = {0.2, 3, 7};
  return swimmer;
}

TEST_P(InertialMethod, SendsMirroredSwimmerTheOtherWay) {
  constexpr double roundoff = 1e-9;
  const CollinearSwimmer swimmer = unequal_heavy_and_light();
  EXPECT_NEAR(velocity(ask(mirrored(swimmer))) / velocity(ask(swimmer)), -1, roundoff);
}

// A mirror-symmetric swimmer, driven so that its mirror image is itself half a period later, or at once.
// (Reciprocal strokes of others may swim by inertia.)
TEST_P(InertialMethod, LeavesMirrorSymmetricSwimmerWhereItIs) {
  constexpr double roundoff = 1e-12;
  CollinearSwimmer swimmer = with_amplitude(with_density(paper_swimmer(1000), 3), 0.2);
  const double scale = velocity(ask(swimmer));
  for (const double phase : {0.0, pi}) {
    swimmer.phase = phase;
    EXPECT_LT(std::abs(velocity(ask(swimmer)) / scale), roundoff) << "alpha = " << phase;
  }
}

TEST_P(InertialMethod, SendsOppositePhaseOfEqualBeadsTheOtherWay) {
  constexpr double roundoff = 1e-9;
  CollinearSwimmer swimmer = with_amplitude(with_density(paper_swimmer(2000), 4), 0.2);
  const double forward = velocity(ask(swimmer));
  swimmer.phase = -swimmer.phase;
  EXPECT_NEAR(velocity(ask(swimmer)) / forward, -1, roundoff);
}

INSTANTIATE_TEST_SUITE_P(All, InertialMethod, testing::Values("unsteady-response", "inertia-corrected"),
                         test_name);

// ---- Refusals

TEST(InertialMethods, RefuseLayersThatAreThinAgainstABead) {
  CollinearSwimmer swimmer = paper_swimmer(2000);
  swimmer.viscosity = 1e-6;
  for (const char* method : {"unsteady-response", "inertia-corrected"}) {
    const std::string reason = obstacle(find_method(method), ask(swimmer));
    EXPECT_NE(
        reason.find("times smaller than the largest bead radius, above the limit of 141 times; increase "),
        std::string::npos)
        << method << reason;
    EXPECT_THROW(predicted(method, ask(swimmer)), InputError);
  }
}

TEST(InertialMethods, RefuseSurroundingsWithoutTheory) {
  Question question = ask(paper_swimmer(2000));
  question.surroundings.obstacle = "its box has no-slip walls";
  for (const char* method : {"unsteady-response", "inertia-corrected"}) {
    EXPECT_EQ(obstacle(find_method(method), question), question.surroundings.obstacle) << method;
  }
}

TEST(InertialMethods, RefuseBeadsThatOverlap) {
  CollinearSwimmer swimmer = paper_swimmer(2000);
  swimmer.arm = {7.9, 20};
  for (const char* method : {"unsteady-response", "inertia-corrected"})
    EXPECT_NE(obstacle(find_method(method), ask(swimmer)), "") << method;
}

}  // namespace
}  // namespace beadswim
