#include "beadswim/theory/passive_diffusion.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace beadswim {
namespace {

// viscosity such that a bead of radius 1 has the mobility 1
Fluid warm_fluid() {
  return {.density = 1, .kinematic_viscosity = 1 / (6 * std::numbers::pi), .thermal_energy = 1};
}

/// Returns equal beads of radius 1 on a line.
SwimmerType line_of(int beads, double distance) {
  SwimmerType type;
  for (int b = 0; b < beads; ++b)
    type.beads.push_back({{.radius = 1, .density = 1}, Vec3((b - (beads - 1) / 2.0) * distance, 0, 0)});
  return type;
}

// Rotational diffusion of three equal beads, by exact inversion of their Rotne-Prager mobility: across the line
// the middle bead stays, and the outer two have the mobility 1 - 3/(4 d) (1 + 2/(3 d^2)) at the distance d = 2 l.
TEST(PassiveDiffusion, OfATripleIsThatOfItsPairMobility) {
  for (const double l : {2.5, 5.0, 16.0 / 3}) {
    const double d = 2 * l, mobility = 1 - 3 / (4 * d) * (1 + 2 / (3 * d * d));
    EXPECT_NEAR(passive_diffusion(line_of(3, l), warm_fluid()).rotation, mobility / (2 * l * l), 1e-12) << l;
  }
  EXPECT_NEAR(passive_diffusion(line_of(3, 2.5), warm_fluid()).rotation, 0.067680, 1e-5);
  EXPECT_NEAR(passive_diffusion(line_of(3, 5), warm_fluid()).rotation, 0.018490, 3e-5 * 0.0185);
}

TEST(PassiveDiffusion, OfOneAndTwoBeads) {
  const PassiveDiffusion one = passive_diffusion(line_of(1, 1), warm_fluid());
  EXPECT_NEAR(one.translation, 1, 1e-12);
  EXPECT_EQ(one.rotation, 0);
  constexpr double l = 4, along = 3 / (2 * l) * (1 - 2 / (3 * l * l)), across = 3 / (4 * l) * (1 + 2 / (3 * l * l));
  const PassiveDiffusion two = passive_diffusion(line_of(2, l), warm_fluid());
  EXPECT_NEAR(two.translation, ((1 + along) / 2 + 2 * (1 + across) / 2) / 3, 1e-12);
  EXPECT_NEAR(two.rotation, 2 * (1 - across) / (l * l), 1e-12);
}

TEST(PassiveDiffusion, OfATriangleHasThreeRotations) {
  SwimmerType type = line_of(3, 4);
  type.beads[2].at = Vec3(-4 + 2, 2 * std::sqrt(3.0), 0);
  const PassiveDiffusion flat = passive_diffusion(type, warm_fluid());
  EXPECT_GT(flat.rotation, 0);
  EXPECT_LT(flat.translation, 1);
}

// Arms that change together: the mean of the diffusion of triples at rest.
TEST(PassiveDiffusion, IsItsMeanOverTheStroke) {
  SwimmerType type = line_of(3, 5);
  for (const int k : {0, 1})
    type.bonds.push_back({{.stiffness = 1, .rest_length = 5, .damping = 0}, {k, k + 1}});
  const double amplitude = 2, mean = 5.5;
  PassiveDiffusion expected;
  constexpr int times = 100;
  for (int t = 0; t < times; ++t) {
    const double l = mean + amplitude * std::cos(2 * std::numbers::pi * t / times);
    const auto [translation, rotation] = passive_diffusion(line_of(3, l), warm_fluid());
    expected.translation += translation / times;
    expected.rotation += rotation / times;
  }
  const ThermalPrediction found =
      predicted_diffusion(type, warm_fluid(), 0, {{amplitude, amplitude}, {1, 1}}, {mean, mean});
  EXPECT_NEAR(found.passive_diffusion, expected.translation, 1e-6 * expected.translation);
  EXPECT_NEAR(found.rotational_diffusion, expected.rotation, 1e-6 * expected.rotation);
  EXPECT_NEAR(found.rotational_diffusion / passive_diffusion(line_of(3, mean), warm_fluid()).rotation, 1.2,
              0.1);
}

// The mean square displacement begins as 6 D_0 t + v^2 t^2 and ends with the slope 6 D.
TEST(PassiveDiffusion, TurnsASwimmersMotionIntoDiffusion) {
  constexpr double speed = 3;
  const ThermalPrediction diffusion = predicted_diffusion(line_of(3, 5), warm_fluid(), speed);
  EXPECT_NEAR(mean_square_displacement(diffusion, speed, 1e-3) - 6e-3 * diffusion.passive_diffusion, 9e-6, 1e-9);
  const double late = 1e4 / diffusion.rotational_diffusion;
  EXPECT_NEAR((mean_square_displacement(diffusion, speed, 2 * late) -
               mean_square_displacement(diffusion, speed, late)) /
                  late,
              6 * diffusion.effective_diffusion, 1e-6 * diffusion.effective_diffusion);
  EXPECT_NEAR(mean_cosine(diffusion, 1 / diffusion.rotational_diffusion), std::exp(-2), 1e-12);
  EXPECT_NEAR(diffusion.peclet, speed * 12 / diffusion.passive_diffusion, 1e-12);
}

}  // namespace
}  // namespace beadswim
