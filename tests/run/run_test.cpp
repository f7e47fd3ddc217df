#include "beadswim/run/run.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "../shared_folder.hpp"
#include "beadswim/core/error.hpp"
#include "beadswim/core/temporary_file.hpp"
#include "beadswim/run/checkpoints.hpp"
#include "beadswim/scene/presets.hpp"

namespace beadswim {
namespace {

RunTask task_of(RunModel model, double cycles) {
  RunTask task{.document = {.layout = paper_single()}, .settings = {}, .source = "layout"};
  task.document.layout.domain.box.reset();
  task.settings.model = model;
  task.settings.cycles = cycles;
  return task;
}

/// Returns a small swimmer on a coarse lattice, with a period of about a hundred time steps.
RunTask lattice_task(double cycles) {
  RunTask task = task_of(RunModel::lbm, cycles);
  Layout& layout = task.document.layout;
  layout.domain.box = Box{.lengths = {64, 32, 32}, .boundary = {}};
  layout.swimmers.front().position = {32, 16, 16};
  for (auto& [name, type] : layout.types) type.driving.period = 400;
  task.settings.lattice.cells_per_radius = 2;
  task.settings.lattice.relaxation_time = 1.5;
  return task;
}

RunResult run_of(RunTask task, const RunSinks& sinks, const Communicator& communicator) {
  const std::unique_ptr<ModelPlan> plan = plan_for(task, communicator);
  return run(task, *plan, sinks, communicator);
}

/// Returns the paths of all files in the current folder.
std::set<std::string> files_here() {
  std::set<std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(".")) files.insert(entry.path());
  return files;
}

/// Catches a library that prints or writes what nobody asked for.
TEST(Run, NeedsNeitherSinksNorFiles) {
  const Communicator self(MPI_COMM_SELF);
  const std::set<std::string> before = files_here();
  testing::internal::CaptureStderr();
  testing::internal::CaptureStdout();
  const RunResult result = run_of(task_of(RunModel::rpy, 2), {}, self);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(files_here(), before);
  EXPECT_EQ(result.record.status, RunStatus::finished);
  EXPECT_EQ(result.last_checkpoint, "");
  ASSERT_EQ(result.record.swimmers.size(), 1u);
  ASSERT_EQ(result.record.swimmers[0].cycles.size(), 2u);
  EXPECT_GT(result.record.swimmers[0].cycles[1].speed_along_axis, 0);
}

/// Catches a run whose ranks wait for those of other runs: each rank runs its own scene for another time.
TEST(Run, UsesItsCommunicatorAlone) {
  const Communicator world(MPI_COMM_WORLD), self(MPI_COMM_SELF);
  const RunResult result = run_of(lattice_task(1 + world.rank()), {}, self);
  EXPECT_EQ(result.record.status, RunStatus::finished);
  EXPECT_EQ(std::ssize(result.record.swimmers[0].cycles), 1 + world.rank());
}

/// Catches a request to stop that one rank alone has seen, and progress that other ranks report too.
TEST(Run, StopsOnAllRanksWhereOneRankAsks) {
  const Communicator world(MPI_COMM_WORLD);
  long progress = 0;
  const int last = world.size() - 1;
  const RunSinks sinks{.progress = [&](long steps) { progress = steps; },
                       .stop = [&, asked = 0]() mutable -> std::optional<EarlyStop> {
                         if (world.rank() != last || ++asked < 3) return std::nullopt;
                         return EarlyStop{.status = RunStatus::stopped_time, .reason = "it is late"};
                       }};
  const RunResult result = run_of(lattice_task(100), sinks, world);
  EXPECT_EQ(result.record.status, RunStatus::stopped_time);
  EXPECT_THAT(result.record.reason, testing::EndsWith("it is late"));
  EXPECT_EQ(result.steps_done, 60);
  EXPECT_EQ(progress, world.is_root() ? 60 : 0);
}

/// Catches a checkpoint that stores other settings than those of the run, or a state that is not the same.
TEST(Run, ContinuesFromItsCheckpointWithTheSameBits) {
  const Communicator world(MPI_COMM_WORLD);
  const SharedFolder folder(world);
  const std::string path = folder.file("run.h5md");
  RunTask first = lattice_task(2);
  first.trajectory = path;
  first.settings.checkpoint_every = 1;
  const RunResult whole = run_of(std::move(first), {}, world);
  RunTask second = lattice_task(2);
  second.trajectory = path + ".2.h5md";
  second.checkpoint = open_checkpoint(path + ".ckpt.0", {}, world);
  second.settings = settings_of(*second.checkpoint);
  const RunResult rest = run_of(std::move(second), {}, world);
  EXPECT_EQ(rest.record.state_sha256, whole.record.state_sha256);
  EXPECT_EQ(rest.record.swimmers.size(), whole.record.swimmers.size());
}

/// Catches a checkpoint of another version that ends a stream: it is refused, and a stream begins anew.
TEST(Run, RefusesACheckpointWithoutSettings) {
  const Communicator self(MPI_COMM_SELF);
  const std::string trajectory = std::filesystem::temp_directory_path() / fmt::format("beadswim-{}.h5md", getpid());
  const std::string path = trajectory + ".ckpt.0";
  OutgoingMessage moment;
  moment(long{7});
  CheckpointWriter file(path, self);
  file.add("moment", moment.bytes());
  file.finish();
  EXPECT_THROW(settings_of(CheckpointReader(path, self)), InputError);
  EXPECT_EQ(open_interrupted_run(trajectory, "", {}, self), nullptr);
  std::filesystem::remove(path);
}

/// Catches a failure after which the caller cannot go on: on one rank run() must throw it.
TEST(Run, ThrowsWhatFailsAfterItsStart) {
  const Communicator self(MPI_COMM_SELF);
  std::string checkpoint = "none was told";
  const RunSinks sinks{.progress = [](long) { throw SolverError("the disk is full"); },
                       .failure = [&](const std::string& last) { checkpoint = last; }};
  EXPECT_THROW(run_of(lattice_task(1), sinks, self), SolverError);
  EXPECT_EQ(checkpoint, "");
}

}  // namespace
}  // namespace beadswim
