// Tests of swarms that consist of blocks, and of the smallest periodic box whose copies give a swarm.
#include <gtest/gtest.h>

#include <algorithm>
#include <ctime>
#include <limits>

#include "beadswim/core/error.hpp"
#include "beadswim/scene/check.hpp"
#include "beadswim/scene/presets.hpp"
#include "beadswim/scene/reduce.hpp"
#include "beadswim/swimmers/swimmer_shape.hpp"
#include "swarm_scene.hpp"
#include "three_bead_types.hpp"

namespace beadswim {
namespace {

// The paper's blocks: 2 l + 32 = 96 and 3 x 32 for the uniform swarm, 2 l + 56 and 2 x 37 + 46 for the other.
TEST(Swarm, HasThePapersBlocks) {
  const SwimmerType type = paper_swarm().types.at("a");
  EXPECT_EQ(block_lengths(paper_uniform_plan(), type), Vec3(96, 96, 96));
  EXPECT_EQ(block_lengths(paper_defect_plan(), type), Vec3(120, 120, 120));
}

// Gaps as measured from what the layout says, through the box's boundary too: catches C and D, or axes, mixed
// up.
TEST(Swarm, KeepsTheGapsOfThePlan) {
  const SwarmPlan plan{.block_swimmers = Index3(2, 3, 1),
                       .blocks = Index3(2, 1, 3),
                       .core_gap = Vec3(20, 25, 30),
                       .block_gap = Vec3(40, 50, 60)};
  SwimmerType type = paper_swarm().types.at("a");
  change(type, [](ThreeBeadSwimmer& three) {
    three.springs[0].rest_length = 30;
    three.springs[1].rest_length = 34;
  });
  const Layout layout = swarm_of(plan, type);
  ASSERT_EQ(layout.swimmers.size(), 36);
  EXPECT_TRUE(check_layout(layout).empty());
  // Along a line of swimmers, the gaps from each to the next, the last to the first one's image.
  const auto gaps_along = [&](int axis) {
    const Swimmer& first = layout.swimmers.front();
    std::vector<double> places;
    for (const Swimmer& swimmer : layout.swimmers) {
      Vec3 apart = swimmer.position - first.position;
      apart[axis] = 0;
      if (apart.norm() < 1e-12) places.push_back(swimmer.position[axis]);
    }
    std::ranges::sort(places);
    places.push_back(places.front() + layout.domain.box->lengths[axis]);
    std::vector<double> gaps;
    for (std::size_t n = 1; n < places.size(); ++n)
      gaps.push_back(places[n] - places[n - 1] - (axis == 0 ? 64 : 0));
    return gaps;
  };
  EXPECT_EQ(gaps_along(0), (std::vector<double>{20, 40, 20, 40}));
  EXPECT_EQ(gaps_along(1), (std::vector<double>{25, 25, 50}));
  EXPECT_EQ(gaps_along(2), (std::vector<double>{60, 60, 60}));
  // Half an outer gap at the box's faces.
  const Swimmer& first = layout.swimmers.front();
  EXPECT_EQ(rest_positions(type, first.position, first.orientation())[0][0], 20);
  // Block by block: the six of a block are in its sixth of the box.
  const Vec3 block = block_lengths(plan, type);
  for (std::size_t s = 0; s < layout.swimmers.size(); ++s) {
    EXPECT_EQ(layout.swimmers[s].id, static_cast<int>(s));
    const Vec3 in_block = layout.swimmers[s].position - layout.swimmers[s / 6 * 6].position;
    EXPECT_TRUE((in_block.array() >= 0).all() && (in_block.array() < block.array()).all()) << s;
  }
}

TEST(Reduce, FindsTheUniformSwarmsOneSwimmerAndTheDefectSwarmsNine) {
  const SwimmerType type = paper_swarm().types.at("a");
  SwarmPlan uniform = paper_uniform_plan(), defect = paper_defect_plan();
  uniform.blocks = Index3(3, 2, 4);
  defect.blocks = Index3(2, 5, 1);
  const ReducedCell one = reduce(swarm_of(uniform, type), 1e-9);
  EXPECT_EQ(one.layout.swimmers.size(), 1);
  EXPECT_EQ(one.layout.domain.box->lengths, Vec3(96, 32, 32));
  EXPECT_TRUE((one.cells == Index3(3, 6, 12)).all());
  const ReducedCell nine = reduce(swarm_of(defect, type), 1e-9);
  EXPECT_EQ(nine.layout.swimmers.size(), 9);
  EXPECT_EQ(nine.layout.domain.box->lengths, Vec3(120, 120, 120));
  EXPECT_TRUE(check_layout(nine.layout).empty());
}

// What differs in one swimmer alone is not repeated: place, axis, type, driving. Within tolerance it is.
TEST(Reduce, KeepsWhatDiffers) {
  const SwimmerType type = paper_swarm().types.at("a");
  SwarmPlan plan = paper_uniform_plan();
  plan.blocks = Index3(2, 1, 1);
  const Layout swarm = swarm_of(plan, type);
  const auto cells_with = [&](auto&& change, double tolerance = 1e-6) {
    Layout changed = swarm;
    change(changed, changed.swimmers[7]);
    return reduce(changed, tolerance).cells.prod();
  };
  EXPECT_EQ(cells_with([](Layout&, Swimmer&) {}), 18);
  EXPECT_EQ(cells_with([](Layout&, Swimmer& one) { one.position[1] += 1e-3; }), 1);
  EXPECT_EQ(cells_with([](Layout&, Swimmer& one) { one.position[1] += 1e-3; }, 1e-2), 18);
  EXPECT_EQ(cells_with([](Layout&, Swimmer& one) { one.position[1] += 1e-3; }, 15), 18);  // none its own twin
  EXPECT_EQ(cells_with([](Layout&, Swimmer& one) { one.axis = Vec3(1, 1e-6, 0).normalized(); }), 1);
  EXPECT_EQ(cells_with([](Layout& layout, Swimmer& one) {
              layout.types["b"] = layout.types["a"];
              one.type = "b";
            }),
            1);
  EXPECT_EQ(cells_with([](Layout& layout, Swimmer& one) {
              one.driving = layout.types["a"].driving;
              one.driving->phase_offset = 0.1;
            }),
            1);
  EXPECT_EQ(cells_with([](Layout& layout, Swimmer& one) { one.driving = layout.types["a"].driving; }), 18);
  EXPECT_EQ(
      cells_with([](Layout& layout, Swimmer&) { layout.domain.box->boundary[1] = Boundary::free_slip; }), 6);
}

// The reduced cell, repeated, has every swimmer of the scene, also where folding meets the cell's faces.
TEST(Reduce, RepeatsToTheScene) {
  const SwimmerType type = paper_swarm().types.at("a");
  SwarmPlan plan = paper_defect_plan();
  plan.blocks = Index3(2, 2, 3);
  Layout swarm = swarm_of(plan, type);
  for (Swimmer& swimmer : swarm.swimmers) {
    for (int a = 0; a < 3; ++a) {  // so that some are at the faces of cells, to roundoff
      const double length = swarm.domain.box->lengths[a];
      swimmer.position[a] += 97 + 1e-13 * (swimmer.id % 3 - 1);
      swimmer.position[a] -= length * std::floor(swimmer.position[a] / length);
    }
  }
  const ReducedCell cell = reduce(swarm, 1e-9);
  ASSERT_EQ(cell.layout.swimmers.size(), 9);
  for (const Swimmer& swimmer : swarm.swimmers) {
    const auto found = std::ranges::count_if(cell.layout.swimmers, [&](const Swimmer& kept) {
      Vec3 apart = swimmer.position - kept.position;
      for (int a = 0; a < 3; ++a) apart[a] -= 120 * std::round(apart[a] / 120);
      return apart.norm() < 1e-9;
    });
    EXPECT_EQ(found, 1) << swimmer.id;
  }
}

// Eight times as many swimmers take about eight times as long. Copies of one swimmer fold onto one place, in
// which each was compared with all others: 64 times as long.
TEST(Reduce, TakesLinearTime) {
  const SwimmerType type = paper_swarm().types.at("a");
  const auto seconds = [&](int blocks) {
    SwarmPlan plan = paper_uniform_plan();
    plan.blocks = Index3(blocks, blocks, blocks);
    const Layout swarm = swarm_of(plan, type);
    std::clock_t fastest = std::numeric_limits<std::clock_t>::max();
    for (int round = 0; round < 3; ++round) {
      const std::clock_t start = std::clock();
      EXPECT_EQ(reduce(swarm, 1e-6).layout.swimmers.size(), 1);
      fastest = std::min(fastest, std::clock() - start);
    }
    return static_cast<double>(fastest) / CLOCKS_PER_SEC;
  };
  EXPECT_LT(seconds(12), 24 * seconds(6));  // 15,552 and 1944 swimmers
}

TEST(Reduce, RefusesUnboundedFluid) {
  Layout layout = paper_single();
  layout.domain.box.reset();
  EXPECT_THROW(reduce(layout, 1e-9), InputError);
}

}  // namespace
}  // namespace beadswim
