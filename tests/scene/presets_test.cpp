#include "beadswim/scene/presets.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "beadswim/swimmers/swimmer_forces.hpp"
#include "three_bead_types.hpp"

namespace beadswim {
namespace {

constexpr double relative_roundoff = 1e-12;

// The paper, section 4.
TEST(PaperSingle, HasThePapersNumbers) {
  const Layout layout = paper_single();
  const ThreeBeadSwimmer type = three_beads(layout.types.at("a"));
  for (const Bead& bead : type.beads) EXPECT_EQ(bead.radius, 4);
  for (const Spring& spring : type.springs) {
    EXPECT_EQ(spring.rest_length, 20);
    EXPECT_EQ(spring.stiffness, 0.0347);
    EXPECT_EQ(spring.damping, 0);
  }
  EXPECT_EQ(type.driving.amplitude, (std::array{0.2, 0.2}));
  EXPECT_EQ(type.driving.phase, std::numbers::pi / 2);
  EXPECT_EQ(type.driving.period, 4800);
  EXPECT_EQ(layout.fluid.kinematic_viscosity, 1.0 / 3);
  EXPECT_EQ(layout.domain.box->lengths, Vec3(1200, 800, 800));
  EXPECT_EQ(layout.swimmers[0].position, Vec3(600, 400, 400));
}

// nu = (tau - 1/2)/3 in units of the cell and the step.
TEST(UnitResolution, GivesCellAndStepOfOne) {
  const Layout layout = paper_single();
  EXPECT_EQ(layout.resolution->cells_per_radius, 4);
  EXPECT_NEAR((layout.resolution->relaxation_time - 0.5) / 3, layout.fluid.kinematic_viscosity,
              relative_roundoff);
}

// The force, by the force law itself, of moving bead 3 sideways by a small way is ten times that of moving it
// along the arm.
TEST(StraighteningStiffness, ResistsTenTimesMoreSideways) {
  const SwimmerType type = paper_single().types.at("a");
  const double small = 1e-4;
  const auto with_bead_3_at = [](double x, double y) {
    BeadVectors beads = BeadVectors::Zero(3, 3);
    beads.col(0) = Vec3(-20, 0, 0);
    beads.col(2) = Vec3(x, y, 0);
    return beads;
  };
  const double sideways = -angle_forces(type, 0, with_bead_3_at(20, small))(1, 2);
  const double along = -bond_forces(type, 0, with_bead_3_at(20 + small, 0), BeadVectors::Zero(3, 3))(0, 2);
  const double truncation = 1e-6;  // second order in small/arm, and cancellation in the arm's change
  EXPECT_NEAR(sideways / along, 10, 10 * truncation);
}

TEST(CentredPosition, PutsTheMiddleOfAnUnequalSwimmerInTheMiddleOffLatticePlanes) {
  SwimmerType type = paper_single().types.at("a");
  type.beads[0].radius = 3;
  type.beads[2].radius = 5;
  change(type, [](ThreeBeadSwimmer& three) {
    three.springs[0].rest_length = 18;
    three.springs[1].rest_length = 27;
  });
  const Box box{.lengths = Vec3(100, 60, 40), .boundary = {}};
  const Vec3 axis(0, 0.6, 0.8);
  const Vec3 bead_2 = centred_position(type, shortest_turn(axis), box);
  const Vec3 tail = bead_2 - (18 + 3) * axis;
  const Vec3 head = bead_2 + (27 + 5) * axis;
  EXPECT_NEAR(((tail + head) / 2 - Vec3(50, 30, 20) - 3 * Vec3(0.15, 0.05, 0)).norm(), 0, relative_roundoff);
  EXPECT_EQ(centred_position(type, shortest_turn(axis), std::nullopt), Vec3::Zero());
}

// The middle of a box is on a plane of the lattice or halfway between two. A bead is off these planes if its
// distance from the next plane or half plane is at least a tenth of a cell along one of the axes.
TEST(ShiftOffLatticePlanes, KeepsBeadsOffPlanesAtAllUsualResolutions) {
  const SwimmerType type = paper_single().types.at("a");
  const Box periodic{.lengths = Vec3(60, 40, 40), .boundary = {}};
  for (const Vec3& axis : {Vec3(1, 0, 0), Vec3(0, -1, 0), Vec3(0.1, 0.2, 0.9)}) {
    const Vec3 shift = shift_off_lattice_planes(type, axis, periodic);
    EXPECT_NEAR(shift.norm(), type.beads[0].radius * std::hypot(0.15, 0.05), relative_roundoff);
    for (const double cells_per_radius : {2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0}) {
      double furthest = 0;
      for (int a = 0; a < 3; ++a) {
        const double half_cells = 2 * shift[a] * cells_per_radius / type.beads[0].radius;
        furthest = std::max(furthest, std::abs(half_cells - std::round(half_cells)) / 2);
      }
      EXPECT_GE(furthest, 0.1) << cells_per_radius;
    }
  }
}

TEST(ShiftOffLatticePlanes, LeavesASwimmerInTheMiddleBetweenWalls) {
  const Layout layout = paper_single();
  Box box = layout.domain.box.value();
  const SwimmerType& type = layout.types.at("a");
  EXPECT_EQ(shift_off_lattice_planes(type, Vec3::UnitX(), box), Vec3::Zero());
  box.boundary[2] = Boundary::periodic;
  EXPECT_EQ(shift_off_lattice_planes(type, Vec3::UnitX(), box), Vec3(0, 0, 0.05 * 4));
}

}  // namespace
}  // namespace beadswim
