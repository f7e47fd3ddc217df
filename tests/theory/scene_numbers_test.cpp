#include "beadswim/theory/scene_numbers.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "beadswim/scene/presets.hpp"
#include "three_bead_types.hpp"

namespace beadswim {
namespace {

constexpr double roundoff = 1e-12;

TEST(SceneNumbers, OfThePapersSwimmer) {
  const SceneNumbers numbers = scene_numbers(paper_single());
  const TypeNumbers& type = numbers.types.at("a");
  const double omega = 2 * std::numbers::pi / 4800;
  EXPECT_NEAR(type.penetration_depth, std::sqrt(2.0 / 3 / omega), 1e-10);
  EXPECT_NEAR(type.arm_over_radius[0], 5, roundoff);
  EXPECT_NEAR(type.drag_over_spring[0], 6 * std::numbers::pi / 3 * 4 * omega / 0.0347, roundoff);
  EXPECT_EQ(type.arm_gaps, (std::vector{12.0, 12.0}));
  EXPECT_EQ(numbers.smallest_gap, 12);
  EXPECT_NEAR((*type.box_over_swimmer_length)[0], 1200.0 / 48, roundoff);
  EXPECT_NEAR(numbers.resolution->cell, 1, roundoff);
  EXPECT_NEAR(numbers.resolution->time_step, 1, roundoff);
  EXPECT_NEAR(*numbers.resolution->cells_in_box, 768e6, 1e-3);
}

/// Returns the arm amplitudes by equations (4.4) and (4.5) of the paper: equal beads and arms, lowest order
/// in lambda/l.
std::array<double, 2> paper_amplitudes(double A, double B, double alpha, double k, double W) {
  const double denominator = std::pow(k, 4) + 40 * W * W * k * k + 144 * std::pow(W, 4);
  const double cross = 4 * A * B * W * k * std::sin(alpha);
  const double mixed = 4 * A * B * std::cos(alpha);
  return {std::sqrt((A * A * k * k + 4 * W * W * (4 * A * A + B * B + mixed) - cross) / denominator),
          std::sqrt((B * B * k * k + 4 * W * W * (A * A + 4 * B * B + mixed) + cross) / denominator)};
}

// Far apart the beads no longer see each other: the difference must go with the radius over the arm.
TEST(SceneNumbers, ArmAmplitudesTendToThePapersForLongArms) {
  const double A = 0.2, B = 0.13, alpha = 0.7, k = 0.0347, T = 4800;
  const double W = std::numbers::pi / 3 * (2 * std::numbers::pi / T) * 4;  // pi eta omega lambda
  const auto expected = paper_amplitudes(A, B, alpha, k, W);
  for (const double arm : {400.0, 4000.0}) {
    Layout layout = paper_single();
    layout.domain.box.reset();
    change(layout.types["a"], [&](ThreeBeadSwimmer& type) {
      for (Spring& spring : type.springs) spring.rest_length = arm;
      type.driving = {.amplitude = {A, B}, .phase = alpha, .period = T};
    });
    const auto amplitude = scene_numbers(layout).types.at("a").arm_amplitudes;
    const double truncation = 4 / arm;  // first order in lambda/l, factor about 1
    EXPECT_NEAR(amplitude[0] / expected[0], 1, truncation);
    EXPECT_NEAR(amplitude[1] / expected[1], 1, truncation);
  }
}

// The swarm's swimmer has a bead Reynolds number of "about 0.8", arm amplitudes 7.4 and 10.3 (model: exact
// Stokes flow; Rotne-Prager differs by some per cent at l = 5.3 lambda).
TEST(SceneNumbers, OfTheSwarmsSwimmer) {
  Layout layout = paper_single();
  change(layout.types["a"], [](ThreeBeadSwimmer& type) {
    for (Bead& bead : type.beads) bead.radius = 6;
    type.springs.fill({.stiffness = 0.2, .rest_length = 32, .damping = 0});
    type.driving = {.amplitude = {2, 2}, .phase = std::numbers::pi / 2, .period = 2000};
  });
  const TypeNumbers numbers = scene_numbers(layout).types.at("a");
  EXPECT_NEAR(numbers.reynolds_bead.value(), 0.8, 0.1);
  EXPECT_NEAR(numbers.arm_amplitudes[0], 7.4, 0.05 * 7.4);
  EXPECT_NEAR(numbers.arm_amplitudes[1], 10.3, 0.05 * 10.3);
}

}  // namespace
}  // namespace beadswim
