#include <unistd.h>

#include <filesystem>

#include "accepted.hpp"
#include "beadswim/coupling/refinement.hpp"
#include "beadswim/run/checkpoints.hpp"
#include "checkpoint_edits.hpp"
#include "memory_file.hpp"
#include "one_rank.hpp"
#include "run_parts.hpp"

// Fuzz target: restarts of runs with checkpoints that have a correct hash, but contents that no run has
// written. The bytes select the changes of the contents. The run must continue, or report why it cannot
// continue.

using namespace beadswim;

namespace {

constexpr double most_cells = 30000;  ///< of scenes that layouts may be edited to
constexpr std::size_t most_swimmers = 10;

/// A folder in memory for this process. The destructor removes it.
struct Folder {
  std::filesystem::path path = memory_folder() + "/beadswim-fuzz." + std::to_string(getpid());
  Folder() { std::filesystem::create_directory(path); }
  ~Folder() { std::filesystem::remove_all(path); }
  std::string file(const std::string& name) const { return path / name; }
};

const Folder& folder() {
  static const Folder one;
  return one;
}

bool is_small(const ModelPlan& plan) {
  const double updates = plan.lattice() ? updates_per_step(plan.lattice()->scene.all_levels()) : 0;
  return updates <= most_cells && plan.swimmers.size() <= most_swimmers && plan.steps_per_cycle < 100000;
}

std::string layout_file(const std::string& box) {
  const std::string bead = R"({"radius":2,"density":1})",
                    spring = R"({"stiffness":0.03,"rest_length":8,"damping":0})";
  const std::string path = folder().file("layout.json");
  write_text(
      path,
      R"({"schema":"beadswim/layout/1","units":"lattice","fluid":{"density":1,"kinematic_viscosity":0.333},)"
      R"("domain":)" +
          box + R"(,"types":{"a":{"beads":[)" + bead + "," + bead + "," + bead + R"(],"springs":[)" + spring +
          "," + spring +
          R"(],"angular_stiffness":1,"driving":{"amplitude":[0.01,0.02],"phase":1.5,"period":60}}},)"
          R"("swimmers":[{"id":3,"type":"a","position":[12,6,6],"axis":[1,0,0]}]})");
  return path;
}

/// Performs some steps of a new run, and returns the contents of the checkpoint that the run writes.
CheckpointContents contents_after(const std::string& box, const RunSettings& settings,
                                  CheckpointContents contents) {
  RunTask task{.document = read_layout(layout_file(box)),
               .settings = settings,
               .source = "layout",
               .trajectory = folder().file("run.h5md")};
  const auto plan = plan_for(task, one_rank());
  const RunResult result = run(task, *plan, {}, one_rank());
  require(result.record.status == RunStatus::finished, "the run gets to its end");
  contents.read(CheckpointReader(result.last_checkpoint, one_rank()));
  return contents;
}

RunSettings short_run(RunModel model) {
  RunSettings settings;
  settings.model = model;
  settings.cycles = 0.7;
  settings.frames_per_cycle = 4;
  settings.checkpoint_every = 9;
  settings.mobility.steps_per_cycle = 20;
  settings.lattice.cells_per_radius = 2;
  return settings;
}

const CheckpointContents& mobility_run() {
  static const CheckpointContents contents = contents_after("null", short_run(RunModel::rpy),
                                                            {.sections = {{"program", ""},
                                                                          {"settings", ""},
                                                                          {"layout", ""},
                                                                          {"moment", ""},
                                                                          {"overdamped", ""},
                                                                          {"record", ""},
                                                                          {"trajectory", ""}}});
  return contents;
}

const CheckpointContents& lattice_run() {
  static const CheckpointContents contents = contents_after(
      R"({"lengths":[24,12,12],"boundary":["periodic","periodic","periodic"]})", short_run(RunModel::lbm),
      {.sections = {{"program", ""},
                    {"settings", ""},
                    {"layout", ""},
                    {"moment", ""},
                    {"swimmers", ""},
                    {"record", ""},
                    {"trajectory", ""}},
       .cells = Index3(24, 12, 12),
       .components = 19});
  return contents;
}

/// Continues from a checkpoint as run() does before its time loop, and performs two time steps.
void go_on_from(const std::string& path) {
  RunTask task;
  task.checkpoint = open_checkpoint(path, {}, one_rank());
  const CheckpointReader& checkpoint = *task.checkpoint;
  task.document = layout_from_json(parse_json(layout_of(checkpoint), "layout"), "layout");
  task.settings = settings_of(checkpoint);
  task.trajectory = trajectory_of(path);
  const auto plan = plan_for(task, one_rank());
  if (!is_small(*plan)) return;
  const auto model = plan->make();
  TrajectoryWriter trajectory(task.trajectory, header_of(task.document, *plan), one_rank(), &checkpoint);
  Recorder recorder(*plan, task.document.layout, &trajectory, one_rank());
  Checkpoints checkpoints(task, *plan, one_rank());
  const RunHistory history =
      restore({one_rank(), *plan, {}, *model, &trajectory, recorder, nullptr, checkpoints}, checkpoint);
  require(history.steps_done == model->steps_done() && history.steps_done >= 0,
          "the run goes on at its step");
  const std::vector<char> record = checkpoint.bytes("record");
  require(recorder.state() == record, "the record is as it was");
  for (int n = 0; n < 2 && !model->fault(); ++n) {
    model->step();
    recorder.sample(*model);
    if (recorder.is_due(model->steps_done())) recorder.record(*model, model->totals());
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  ByteSource edits(data, size);
  CheckpointContents contents = edits.choice(2) == 0 ? mobility_run() : lattice_run();
  contents.edit(edits);
  const std::string checkpoint = folder().file("edited.h5md.ckpt.0");
  contents.write(checkpoint, one_rank());
  try {
    accepts([&] { go_on_from(checkpoint); });
  } catch (const SolverError&) {  // it does not hold what this version writes
  }
  H5close();  // a run that fails leaves files open, which the end of the process closes
  return 0;
}
