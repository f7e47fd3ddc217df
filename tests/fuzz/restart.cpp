#include <unistd.h>

#include <filesystem>

#include "accepted.hpp"
#include "checkpoint_edits.hpp"
#include "checkpoints.hpp"
#include "command_line/request.hpp"
#include "memory_file.hpp"
#include "one_rank.hpp"
#include "run_setup.hpp"

// Fuzz target: beadswim-run --restart with checkpoints that have a correct hash, but contents that no run has
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

Request request_of(std::vector<std::string> arguments) {
  std::vector<char*> pointers;
  arguments.insert(arguments.begin(), "beadswim-run");
  for (std::string& argument : arguments) pointers.push_back(argument.data());
  return std::get<Request>(read_request(static_cast<int>(pointers.size()), pointers.data(), one_rank()));
}

bool is_small(const ModelPlan& plan) {
  return plan.updates_per_step.value_or(0) <= most_cells && plan.swimmers.size() <= most_swimmers &&
         plan.steps_per_cycle < 100000;
}

/// Performs some steps of a new run, and returns the contents of the checkpoint that the run writes.
CheckpointContents contents_after(const std::vector<std::string>& arguments, CheckpointContents contents) {
  const Request request = request_of(arguments);
  const LayoutDocument document = read_layout(request.options.layouts.front());
  const auto plan = plan_for(document, request, one_rank());
  const auto model = plan->make(0);
  TrajectoryWriter trajectory(request.options.output, header_of(document, *plan), one_rank());
  Recorder recorder(*plan, document.layout, trajectory, one_rank());
  Checkpoints checkpoints(plan->options, dump_json(layout_to_json(document)), "", one_rank());
  Progress progress(ProgressStyle::none, 0, 1, 1, plan->updates_per_step);
  const RunParts parts{0, one_rank(), *plan, *model, trajectory, recorder, checkpoints, progress};
  require(run_to_end(parts, std::nullopt).status == RunStatus::finished, "the run gets to its end");
  contents.read(CheckpointReader(checkpoints.last(), one_rank()));
  return contents;
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

const CheckpointContents& mobility_run() {
  static const CheckpointContents contents =
      contents_after({layout_file("null"), "-o", folder().file("rpy.h5md"), "--model", "rpy", "--cycles",
                      "0.7", "--steps-per-cycle", "20", "--frames-per-cycle", "4", "--checkpoint-every", "9"},
                     {.sections = {{"program", ""},
                                   {"flags", ""},
                                   {"layout", ""},
                                   {"moment", ""},
                                   {"overdamped", ""},
                                   {"record", ""},
                                   {"trajectory", ""}}});
  return contents;
}

const CheckpointContents& lattice_run() {
  static const CheckpointContents contents =
      contents_after({layout_file(R"({"lengths":[24,12,12],"boundary":["periodic","periodic","periodic"]})"),
                      "-o", folder().file("lbm.h5md"), "--cells-per-radius", "2", "--cycles", "0.7",
                      "--frames-per-cycle", "4", "--checkpoint-every", "9"},
                     {.sections = {{"program", ""},
                                   {"flags", ""},
                                   {"layout", ""},
                                   {"moment", ""},
                                   {"swimmers", ""},
                                   {"record", ""},
                                   {"trajectory", ""}},
                      .cells = Index3(24, 12, 12),
                      .components = 19});
  return contents;
}

/// Continues from a checkpoint as main() of the program does before its time loop, and performs two time
/// steps.
void go_on_from(const std::string& checkpoint) {
  Request request = request_of({"--restart", checkpoint, "--progress", "none"});
  const LayoutDocument document = read_layout(request, std::nullopt);
  const auto plan = plan_for(document, request, one_rank());
  if (!is_small(*plan)) return;
  const auto model = plan->make(0);
  TrajectoryWriter trajectory(request.options.output, header_of(document, *plan), one_rank(),
                              request.checkpoint.get());
  Recorder recorder(*plan, document.layout, trajectory, one_rank());
  const RunHistory history = restore(*model, recorder, *request.checkpoint, one_rank());
  require(history.steps_done == model->steps_done() && history.steps_done >= 0,
          "the run goes on at its step");
  const std::vector<char> record = request.checkpoint->bytes("record", 0, request.checkpoint->size("record"));
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
