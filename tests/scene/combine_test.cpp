// Tests of combined scenes: a rigid motion keeps the distances of beads, ids are new, and types with other
// content get other names.
#include "beadswim/scene/combine.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "beadswim/core/error.hpp"
#include "beadswim/scene/bead_gaps.hpp"
#include "beadswim/scene/check.hpp"
#include "beadswim/scene/gallery.hpp"
#include "swarm_scene.hpp"

namespace beadswim {
namespace {

Layout triangles() {
  Layout layout;
  layout.fluid = {.density = 1, .kinematic_viscosity = 1};
  layout.types["triangle"] = swimmer_type(Triangle{}, layout.fluid);
  layout.swimmers = {{.id = 3, .type = "triangle", .position = Vec3(1, 2, 3)},
                     {.id = 7, .type = "triangle", .position = Vec3(1, 90, 3), .axis = Vec3::UnitZ()}};
  return layout;
}

/// Returns the distances between all beads of the swimmers [first, first + 2) of a layout.
std::vector<double> distances(const Layout& layout, std::size_t first) {
  std::vector<PlacedBead> beads = placed_beads(layout);
  std::erase_if(beads, [first](const PlacedBead& b) { return b.swimmer < first || b.swimmer > first + 1; });
  std::vector<double> result;
  for (const PlacedBead& a : beads)
    for (const PlacedBead& b : beads) result.push_back((a.centre - b.centre).norm());
  return result;
}

// A turn of the positions without the orientations, or the other way round, would change the distances.
TEST(Combine, ATurnKeepsTheDistancesOfAllBeads) {
  const ScenePart still{.layout = triangles(), .source = "first"};
  ScenePart moved = still;
  moved.displacement = Vec3(0, 0, 400);
  moved.turn = Eigen::AngleAxisd(1.1, Vec3(1, 2, -1).normalized());
  const Layout scene = combine(std::array{still, moved});
  ASSERT_TRUE(check_layout(scene).empty());
  const std::vector<double> before = distances(triangles(), 0), first = distances(scene, 0),
                            second = distances(scene, 2);
  ASSERT_EQ(before.size(), second.size());
  EXPECT_EQ(first, before);
  for (std::size_t i = 0; i < before.size(); ++i) EXPECT_NEAR(second[i], before[i], 1e-12 * 100);
}

// Bead k of a part moves by the rotation about the mean of the positions, (1, 46, 3), and the displacement.
TEST(Combine, BeadsMoveByTheTurnAboutTheMeanPosition) {
  ScenePart part{.layout = triangles(), .source = "first", .displacement = Vec3(5, 0, 0)};
  part.turn = Eigen::AngleAxisd(std::numbers::pi / 2, Vec3::UnitZ());
  const std::vector<PlacedBead> before = placed_beads(part.layout), after = placed_beads(combine({&part, 1}));
  for (std::size_t b = 0; b < before.size(); ++b) {
    const Vec3 from_mean = before[b].centre - Vec3(1, 46, 3);
    const Vec3 expected = Vec3(1, 46, 3) + Vec3(-from_mean.y(), from_mean.x(), from_mean.z()) + Vec3(5, 0, 0);
    EXPECT_LT((after[b].centre - expected).norm(), 1e-12 * 100);
  }
}

TEST(Combine, IdsCountFromZeroAndOtherTypesGetFreeNames) {
  const ScenePart first{.layout = triangles(), .source = "first"};
  ScenePart second = first, third = first;
  second.layout.types["triangle"].driving.period *= 2;
  const Layout scene = combine(std::array{first, second, third});
  std::vector<int> ids;
  std::vector<std::string> types;
  for (const Swimmer& swimmer : scene.swimmers) ids.push_back(swimmer.id), types.push_back(swimmer.type);
  EXPECT_EQ(ids, (std::vector{0, 1, 2, 3, 4, 5}));
  EXPECT_EQ(types, (std::vector<std::string>{"triangle", "triangle", "b", "b", "triangle", "triangle"}));
  EXPECT_EQ(scene.types.at("b"), second.layout.types.at("triangle"));
}

TEST(Combine, OtherFluidsDomainsAndUnitsAreNamed) {
  const ScenePart first{.layout = triangles(), .source = "first"};
  const auto message = [&first](auto&& change) {
    ScenePart second{.layout = triangles(), .source = "second"};
    change(second.layout);
    try {
      combine(std::array{first, second});
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_NE(message([](Layout& l) { l.fluid.density = 2; }).find("second: the fluid is"), std::string::npos);
  EXPECT_NE(message([](Layout& l) { l.domain.half_space = HalfSpace{}; }).find("the domain is"),
            std::string::npos);
  EXPECT_NE(message([](Layout& l) { l.units.lattice = false; }).find("units"), std::string::npos);
}

// A swarm of two blocks is twice a swarm of one block in the same box.
TEST(Combine, TwoBlocksAreOneBlockTwice) {
  SwarmPlan plan = paper_uniform_plan();
  plan.blocks = Index3(1, 2, 1);
  const Layout both = swarm_of(plan, paper_swarm().types.at("a"));
  ScenePart one{.layout = both, .source = "one"};
  one.layout.swimmers.resize(both.swimmers.size() / 2);
  ScenePart two = one;
  two.displacement = Vec3(0, both.domain.box->lengths.y() * 1.5, 0);  // once round the periodic box
  const Layout scene = combine(std::array{one, two});
  ASSERT_EQ(scene.swimmers.size(), both.swimmers.size());
  for (std::size_t s = 0; s < both.swimmers.size(); ++s)
    EXPECT_LT((scene.swimmers[s].position - both.swimmers[s].position).norm(), 1e-9);
}

}  // namespace
}  // namespace beadswim
