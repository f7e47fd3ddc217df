#include "beadswim/plan/run_plan.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "beadswim/core/error.hpp"
#include "beadswim/scene/presets.hpp"

namespace beadswim {
namespace {

/// Returns the paper's single swimmer in a periodic box.
Layout single() {
  Layout layout = paper_single();
  layout.domain.box = Box{.lengths = {96, 64, 64}, .boundary = {}};
  layout.swimmers.front().position = layout.domain.box->lengths / 2;
  return layout;
}

/// Returns the speed of a machine on which every cell, and every unit of surface between ranks, has the same
/// cost.
LatticeSpeed any_speed(int ranks) {
  const PrecisionCost one{.cells = {1e3, 1e4, 1e5, 1e6},
                          .seconds_per_cell = std::vector<double>(4, 1e-8),
                          .seconds_per_area = std::vector<double>(all_values<BeadScheme>.size(), 1e-7)};
  return {ranks, {one, one}};
}

PlanRequest lattice_request(const Communicator& communicator) {
  PlanRequest request;
  request.settings.model = RunModel::lbm;
  request.lattice_speed = [&communicator] { return any_speed(communicator.size()); };
  return request;
}

RunPlan plan_of(const PlanRequest& request, const Communicator& communicator) {
  return plan_run(single(), request, "layout", communicator);
}

/// Catches the speed of a busy machine being kept for ever.
TEST(LatticeSpeed, FollowsTheMachine) {
  const Communicator communicator(MPI_COMM_WORLD);
  const LatticeSpeed any = any_speed(communicator.size());
  std::vector<PrecisionCost> slow = any.precisions();
  for (PrecisionCost& one : slow) one.seconds_per_cell.assign(4, 1e-4);  // no machine is so slow
  const LatticeSpeed now = LatticeSpeed(communicator.size(), slow).at_present(communicator);
  for (const PrecisionCost& one : now.precisions()) {
    const double factor = one.seconds_per_cell[2] / 1e-4;
    EXPECT_LT(factor, 0.1);
    EXPECT_GT(factor, 1e-6);
    EXPECT_NEAR(one.seconds_per_area[3] / (factor * 1e-7), 1, 1e-12);
  }
}

/// Catches settings that the user fixed being weighed all the same.
TEST(RunPlan, WeighsOnlyWhatIsOpen) {
  const Communicator communicator(MPI_COMM_WORLD);
  PlanRequest request = lattice_request(communicator);
  request.settings.lattice.precision = Precision::fp32;
  request.chosen = {Setting::precision, Setting::refinement};
  request.settings.lattice.cells_per_radius = 4;
  const RunPlan plan = plan_of(request, communicator);
  EXPECT_GT(plan.runs.size(), 1u);
  for (const PlannedRun& run : plan.runs) {
    EXPECT_EQ(run.settings.model, RunModel::lbm);
    EXPECT_EQ(run.settings.lattice.precision, Precision::fp32);
    EXPECT_EQ(run.settings.lattice.cells_per_radius, 4);
  }
}

/// Catches a choice beyond the tolerance, and one that another run within it undercuts.
TEST(RunPlan, ChoosesTheCheapestWithinTheTolerance) {
  const Communicator communicator(MPI_COMM_WORLD);
  PlanRequest request = lattice_request(communicator);
  request.tolerance = 0.1;
  const RunPlan plan = plan_of(request, communicator);
  ASSERT_TRUE(plan.choice);
  const PlannedRun& choice = plan.runs[*plan.choice];
  EXPECT_LE(choice.errors.limits.total.largest(), 0.1);
  for (const PlannedRun& run : plan.runs) {
    if (run.refused.empty() && run.errors.limits.total.largest() <= 0.1) {
      EXPECT_GE(run.core_seconds, choice.core_seconds);
    }
  }
}

TEST(RunPlan, HasNoChoiceWhereNoRunIsWithinTheTolerance) {
  const Communicator communicator(MPI_COMM_WORLD);
  PlanRequest request = lattice_request(communicator);
  request.tolerance = 1e-9;
  const RunPlan plan = plan_of(request, communicator);
  EXPECT_FALSE(plan.choice);
  EXPECT_TRUE(plan.best);
}

/// Catches costs of restarts that are those of the whole run.
TEST(RunPlan, CountsTheStepsThatARestartHasLeft) {
  const Communicator communicator(MPI_COMM_WORLD);
  PlanRequest request = lattice_request(communicator);
  request.settings.lattice.precision = Precision::fp32;
  request.chosen = {Setting::precision, Setting::refinement};
  request.settings.lattice.cells_per_radius = 4;
  request.settings.lattice.relaxation_time = 1;
  request.settings.lattice.refinement = 0;
  const auto run_after = [&](long steps_done) {
    request.steps_done = steps_done;
    return plan_of(request, communicator).runs.at(0);
  };
  const double whole = run_after(0).core_seconds, first = whole - run_after(500).core_seconds;
  EXPECT_GT(first, 0);
  EXPECT_NEAR(whole - run_after(1000).core_seconds, 2 * first, 1e-9 * whole);
  EXPECT_THAT(run_after(1000000000).refused, testing::HasSubstr("give more cycles"));
}

/// Catches a measurement of the machine for runs that cannot be.
TEST(RunPlan, AsksForTheSpeedOnlyIfALatticeCanRun) {
  const Communicator communicator(MPI_COMM_WORLD);
  PlanRequest request = lattice_request(communicator);
  int asked = 0;
  request.lattice_speed = [&] {
    ++asked;
    return any_speed(communicator.size());
  };
  plan_of(request, communicator);
  EXPECT_EQ(asked, 1);
  request.chosen = {Setting::sum_tolerance};
  const RunPlan plan = plan_of(request, communicator);
  EXPECT_EQ(asked, 1);
  for (const PlannedRun& run : plan.runs)
    EXPECT_THAT(run.refused, testing::HasSubstr("mobility models only"));
}

}  // namespace
}  // namespace beadswim
