#include "beadswim/scene/gallery.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "beadswim/scene/check.hpp"
#include "beadswim/swimmers/swimmer_forces.hpp"

namespace beadswim {
namespace {

constexpr double pi = std::numbers::pi;
const Fluid fluid{.density = 1.5, .kinematic_viscosity = 0.2};

/// Returns the types with the default parameters.
std::map<std::string, SwimmerType> default_types() {
  return {{"dumbbell", swimmer_type(Dumbbell{}, fluid)},
          {"triangle", swimmer_type(Triangle{}, fluid)},
          {"prescribed-three-bead", swimmer_type(PrescribedThreeBead{}, fluid)},
          {"purcell-chain", swimmer_type(PurcellChain{}, fluid)},
          {"flagellum", swimmer_type(Flagellum{}, fluid)},
          {"sphere", swimmer_type(TowedSphere{}, fluid)},
          {"chain", swimmer_type(TowedChain{}, fluid)}};
}

TEST(Gallery, DefaultsAreValidLayouts) {
  for (const auto& [name, type] : default_types()) {
    const Layout layout{.units = {},
                        .fluid = fluid,
                        .domain = {},
                        .types = {{name, type}},
                        .swimmers = {{.id = 0, .type = name}},
                        .resolution = {}};
    for (const LayoutFault& fault : check_layout(layout))
      ADD_FAILURE() << name << fault.place << fault.message;
    EXPECT_EQ(type.beads[0].density, fluid.density) << name;
  }
}

// A run begins at rest on the path of the driven lengths and angles: springs exert no forces at time 0.
TEST(Gallery, BeginsWithoutAJump) {
  Triangle triangle;
  triangle.amplitude = {3, 1, 2};
  triangle.phase = 1.3;
  PrescribedThreeBead three;
  three.arm = {20, 14};
  three.phase = -2;
  PurcellChain chain;
  chain.phase = 0.7;
  for (const SwimmerType& type :
       {swimmer_type(triangle, fluid), swimmer_type(three, fluid), swimmer_type(chain, fluid)}) {
    const BeadVectors beads =
        columns_of_beads(rest_positions(type, Vec3::Zero(), Eigen::Matrix3d::Identity()));
    const double force = type.bonds[0].stiffness * type.bonds[0].rest_length;
    EXPECT_LT(bond_forces(type, 0, beads, 0 * beads).norm(), 1e-13 * force);
    EXPECT_LT(angle_forces(type, 0, beads).norm(), 1e-13 * force);
    EXPECT_GT(bond_forces(type, type.driving.period / 7, beads, 0 * beads).norm() +
                  angle_forces(type, type.driving.period / 7, beads).norm(),
              1e-3 * force);
  }
}

TEST(Gallery, TheTriangleHasTheLengthsOfItsDrives) {
  const SwimmerType type = swimmer_type(Triangle{}, fluid);
  for (std::size_t k = 0; k < 3; ++k)
    EXPECT_NEAR(distance_at_rest(type, type.bonds[k].beads[0], type.bonds[k].beads[1]),
                20 - 4 * std::sin(2 * pi / 3 * static_cast<double>(k)), 1e-13);
}

TEST(Gallery, TheOuterLinksOfPurcellsChainBendToOppositeSides) {
  const SwimmerType type = swimmer_type(PurcellChain{}, fluid);
  ASSERT_EQ(type.beads.size(), 10U);
  const Vec3 first = type.beads[3].at - type.beads[0].at, middle = type.beads[6].at - type.beads[3].at,
             last = type.beads[9].at - type.beads[6].at;
  EXPECT_LT((middle - Vec3(30, 0, 0)).norm(), 1e-13);
  EXPECT_NEAR(first.cross(middle).z() / 900, -std::sin(pi / 3), 1e-14);
  EXPECT_NEAR(middle.cross(last).z() / 900, std::sin(pi / 3 + 2 * pi / 9), 1e-14);
}

TEST(Gallery, TheFlagellumHasItsSpermNumber) {
  Flagellum flagellum;
  flagellum.beads = 11;
  flagellum.radius = {2};
  flagellum.arm = 6;
  flagellum.sperm_number = 2.5;
  const SwimmerType type = swimmer_type(flagellum, fluid);
  const double length = 60, rigidity = type.angles[0].stiffness * 6;
  const double drag = 4 * pi * 0.3 / (std::log(30) + 0.5);
  EXPECT_NEAR(length * std::pow(drag * 2 * pi / flagellum.period / rigidity, 0.25), 2.5, 1e-12);
}

// A stiff flagellum with the drag ζ per length turns by torque/(ζ length^3/12 omega).
TEST(Gallery, DefaultForcesDoNotTurnAStiffFlagellumOver) {
  for (const double sperm_number : {0.1, 1.0, 2.0}) {
    Flagellum flagellum;
    flagellum.sperm_number = sperm_number;
    const SwimmerType type = swimmer_type(flagellum, fluid);
    const double arm = 2.5 * flagellum.radius[0], length = (flagellum.beads - 1) * arm;
    const double drag = 4 * pi * 0.3 / (std::log(length / flagellum.radius[0]) + 0.5);
    const double torque = type.driving.forces[0].harmonics[0].amplitude * arm;
    const double angle = torque / (drag * std::pow(length, 3) / 12 * 2 * pi / flagellum.period);
    EXPECT_NEAR(angle, 0.75, 1e-12) << sperm_number;
  }
}

TEST(Gallery, TheSphereMovesByARadiusInAPeriod) {
  TowedSphere sphere;
  sphere.radius = {2};
  const SwimmerType type = swimmer_type(sphere, fluid);
  EXPECT_NEAR(type.driving.forces[0].constant / (6 * pi * 0.3 * 2) * sphere.period, 2, 1e-12);
}

}  // namespace
}  // namespace beadswim
