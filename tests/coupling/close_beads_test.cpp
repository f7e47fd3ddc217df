// Tests of beads that are close to each other: which bead covers a cell, which pairs are found, and when lost
// mass or momentum is a fault.
#include <gtest/gtest.h>

#include <map>
#include <random>

#include "beadswim/coupling/close_beads.hpp"
#include "beadswim/coupling/coupled_system.hpp"
#include "beadswim/swimmers/three_bead_swimmer.hpp"

namespace beadswim {
namespace {

BeadOnLattice bead_at(int swimmer, const Vec3& position, double radius) {
  return {.name = {swimmer, 0},
          .radius = radius,
          .motion = {.position = position},
          .body = {.radius = radius, .density = 1},
          .impulse = {}};
}

/// A periodic lattice that is one block of one rank.
struct OneBlock {
  explicit OneBlock(const Index3& cells)
      : decomposition(cells, 1), populations(cells, Precision::fp64, HaloContent::entering) {}

  BlockInLattice at() const {
    return {.block = decomposition.lattice(),
            .cells = decomposition.cells(),
            .boundary = {Boundary::periodic, Boundary::periodic, Boundary::periodic}};
  }

  Decomposition decomposition;
  Populations populations;
};

// Every cell inside a bead is covered once, by one whose r^2 - R^2 is least. Catches a cell with two beads,
// one with none, or a split that depends on the beads' order. Seed 5.
TEST(Coverage, PartsBeadsThatOverlap) {
  const OneBlock block(Index3(12, 11, 10));
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(0, 10), shift(-1, 1);
  for (int trial = 0; trial < 40; ++trial) {
    const Vec3 first(place(random), place(random), place(random));
    Vec3 direction(shift(random), shift(random), shift(random));
    if (trial % 4 == 0) direction = Vec3::UnitY();  // ties along rows
    const Vec3 second = first + (trial % 4 == 0 ? 4.0 : 4.6) * direction.normalized();
    const std::vector<BeadOnLattice> beads{bead_at(0, first, 2.5),
                                           bead_at(1, second, trial % 2 == 0 ? 2.5 : 2.1)};
    Coverage coverage(block.at(), block.populations);
    coverage.update(beads);
    std::map<std::ptrdiff_t, std::vector<int>> owners;
    coverage.for_each_own_covered_cell([&](std::ptrdiff_t cell, int bead, const Vec3& from_centre) {
      owners[cell].push_back(bead);
      const Vec3 point = beads[bead].motion.position + from_centre;
      const auto power = [&](const BeadOnLattice& b) {
        return (point - b.motion.position).squaredNorm() - b.radius * b.radius;
      };
      EXPECT_LE(power(beads[bead]), power(beads[1 - bead]) + 1e-12);
    });
    std::size_t inside = 0;  // by looking at every cell and image
    for (int i = 0; i < 36 * 33 * 30; ++i) {
      const Vec3 centre(i % 36 - 11.5, i / 36 % 33 - 10.5, i / (36 * 33) - 9.5);
      const bool is_inside = std::ranges::any_of(beads, [&](const BeadOnLattice& b) {
        for (int k = 0; k < 27; ++k) {
          const Vec3 image =
              b.motion.position + Vec3(12 * (k % 3 - 1), 11 * (k / 3 % 3 - 1), 10 * (k / 9 - 1));
          if ((centre - image).norm() < b.radius) return true;
        }
        return false;
      });
      const bool is_own = (centre.array() > 0).all() && centre[0] < 12 && centre[1] < 11 && centre[2] < 10;
      inside += is_own && is_inside;
    }
    EXPECT_EQ(inside, owners.size());
    for (const auto& [cell, of] : owners) EXPECT_EQ(of.size(), 1U);
  }
}

constexpr NearContactLaw law{.viscosity = 0.2,
                             .range = {.normal = 0.6, .tangential = 0.5, .smallest = 0.01},
                             .stiffness_rate = 0.6,
                             .damping_ratio = 0.5,
                             .friction = 0};

// Through the corner of the box as anywhere else: catches a pair of images missed, or found twice.
TEST(CloseBeads, FindEachPairOnce) {
  const OneBlock block(Index3(12, 12, 12));
  for (const Vec3& first : {Vec3(6, 6, 6), Vec3(0.1, 11.9, 0.2), Vec3(25, -13, 11.9)}) {
    std::vector<BeadOnLattice> beads{
        bead_at(0, first, 2.5),
        bead_at(1, first + 5.1 * Vec3(1, -1, 1).normalized() + Vec3(12, 0, -24), 2.5)};
    beads[1].predicted.linear = Vec3(-0.1, 0.1, -0.1);
    Coverage coverage(block.at(), block.populations);
    coverage.update(beads);
    const CloseBeads found = add_contact_impulses(law, coverage, beads);
    EXPECT_NEAR(found.smallest_gap, 0.1, 1e-12);
    EXPECT_FALSE(found.overlap);
    const CloseBead one{
        .radius = 2.5, .mass = mass(beads[0].body), .inertia = moment_of_inertia(beads[0].body)};
    CloseBead other = one;
    other.velocity = beads[1].predicted.linear;
    const Vec3 expected = near_contact_impulse(law, one, other, 5.1 * Vec3(1, -1, 1).normalized(), 1).linear;
    EXPECT_GT(expected[0], 0.1);
    EXPECT_LT((beads[1].impulse.close.value().force - expected).norm(), 1e-12);
    EXPECT_LT((beads[0].impulse.close.value().force + expected).norm(), 1e-12);
  }
}

// A bead in a box hardly wider than itself turns between its own images: the film on all sides slows it.
TEST(CloseBeads, IncludeABeadsOwnImages) {
  const OneBlock block(Index3(5, 12, 12));
  std::vector<BeadOnLattice> beads{bead_at(0, Vec3(4.9, 3, 3), 2.45)};
  beads[0].predicted.angular = Vec3(0, 0, 0.01);
  Coverage coverage(block.at(), block.populations);
  coverage.update(beads);
  EXPECT_NEAR(add_contact_impulses(law, coverage, beads).smallest_gap, 0.1, 1e-12);
  EXPECT_EQ(beads[0].impulse.close.value().force, Vec3::Zero());
  EXPECT_LT(beads[0].impulse.close.value().torque[2], -1e-4);
  EXPECT_LT(beads[0].impulse.close.value().torque.head<2>().norm(), 1e-15);
}

// The owner of a swimmer evaluates the impulses between its beads. Catches their gap being missed, and
// impulses that act twice; between a bead and an image of another bead of its swimmer they act here.
TEST(CloseBeads, FindGapsWithinASwimmerButItsOwnerAddsTheImpulses) {
  const OneBlock block(Index3(12, 12, 12));
  for (const double image : {0.0, 12.0}) {
    std::vector<BeadOnLattice> beads{bead_at(0, Vec3(4, 6, 6), 2.5),
                                     bead_at(0, Vec3(9.2 + image, 6, 6), 2.5)};
    beads[1].name.bead = 1;
    beads[1].predicted.linear = Vec3(-0.1, 0, 0);
    Coverage coverage(block.at(), block.populations);
    coverage.update(beads);
    EXPECT_NEAR(add_contact_impulses(law, coverage, beads).smallest_gap, 0.2, 1e-12);
    EXPECT_EQ(beads[0].impulse.close.value().force == Vec3::Zero(), image == 0);
  }
}

TEST(CloseBeads, ReportADeepOverlap) {
  const OneBlock block(Index3(16, 12, 12));
  std::vector<BeadOnLattice> beads{bead_at(3, Vec3(4, 5, 5), 2.5), bead_at(8, Vec3(8.4, 5, 5), 2.5)};
  Coverage coverage(block.at(), block.populations);
  coverage.update(beads);
  const CloseBeads found = add_contact_impulses(law, coverage, beads);
  ASSERT_TRUE(found.overlap);
  EXPECT_EQ(found.overlap->bead.swimmer, 3);
  EXPECT_EQ(found.overlap->other.swimmer, 8);
  EXPECT_NEAR(found.overlap->value, 0.6 / 2.5, 1e-12);
}

/// Returns a scene of one swimmer in a box. A bead of radius 1 has the mass 4 pi/3.
CoupledScene swimmer_scene(Boundary across_x, Precision precision) {
  ThreeBeadSwimmer type;
  type.beads.fill({.radius = 1, .density = 1});
  CoupledScene scene;
  scene.boundary[0] = across_x;
  scene.precision = precision;
  scene.types = {swimmer_type(type)};
  scene.swimmers = {{.id = 0, .type = 0}};
  return scene;
}

// Beads of a scene that meet head on at the speed limit, no film between them, turn round and part again
// before they are in each other by half a cell, a quarter of what stops a run at this radius.
TEST(NearContactLaw, TurnsBeadsAtTheSpeedLimit) {
  CoupledScene scene = swimmer_scene(Boundary::periodic, Precision::fp64);
  for (Bead& bead : scene.types[0].beads) bead.radius = 10;
  scene.lubrication = false;
  const NearContactLaw law = near_contact_law(scene);
  CloseBead bead{.radius = 10, .mass = mass(scene.types[0].beads[0]), .inertia = 1};
  CloseBead other = bead;
  bead.velocity[0] = speed_limit;
  other.velocity[0] = -speed_limit;
  double gap = 0.3, deepest = gap;
  for (int step = 0; step < 10; ++step) {
    const double push = near_contact_impulse(law, bead, other, Vec3(20 + gap, 0, 0), 1).linear[0] / bead.mass;
    bead.velocity[0] -= push;
    other.velocity[0] += push;
    gap += other.velocity[0] - bead.velocity[0];
    deepest = std::min(deepest, gap);
  }
  EXPECT_GT(deepest, -0.5);
  EXPECT_GT(gap, 0);
}

// What is lost or gained beyond roundoff is a fault; walls may take momentum, but nothing takes mass, and
// what is no number is always one.
TEST(Conservation, IsWatched) {
  const CoupledScene box = swimmer_scene(Boundary::periodic, Precision::fp64);
  const CoupledScene single = swimmer_scene(Boundary::periodic, Precision::fp32);
  const CoupledScene mirrors = swimmer_scene(Boundary::free_slip, Precision::fp64);
  const SceneTotals start{};
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto kind_of = [&](const CoupledScene& scene, const SceneTotals& now) -> std::optional<FaultKind> {
    const auto fault = conservation_fault(scene, start, now, 0.01);
    return fault ? std::optional(fault->kind) : std::nullopt;
  };
  const SceneTotals roundoff{.momentum = Vec3(1e-12, 0, 0), .mass_excess = 1e-15};
  const SceneTotals pushed{.momentum = Vec3(0, 1e-6, 0)}, lost{.mass_excess = -1e-7};
  EXPECT_EQ(kind_of(box, roundoff), std::nullopt);
  EXPECT_EQ(kind_of(box, pushed), FaultKind::momentum);
  EXPECT_EQ(kind_of(mirrors, pushed), std::nullopt);
  EXPECT_EQ(kind_of(single, pushed), std::nullopt);
  EXPECT_EQ(kind_of(box, lost), FaultKind::mass);
  EXPECT_EQ(kind_of(mirrors, lost), FaultKind::mass);
  EXPECT_EQ(kind_of(single, lost), std::nullopt);
  EXPECT_EQ(kind_of(box, {.momentum = Vec3(nan, 0, 0)}), FaultKind::momentum);
  EXPECT_EQ(kind_of(mirrors, {.mass_excess = nan}), FaultKind::mass);
}

}  // namespace
}  // namespace beadswim
