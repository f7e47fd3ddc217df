#include "checkpoints.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>

#include "beadswim/core/error.hpp"
#include "beadswim/core/version.hpp"
#include "beadswim/io/json.hpp"

namespace beadswim {
namespace {

constexpr const char* flags_section = "flags";
constexpr const char* program_section = "program";
constexpr const char* layout_section = "layout";
constexpr const char* moment_section = "moment";
constexpr const char* record_section = "record";

std::string slot_path(const std::string& trajectory, int slot) {
  return fmt::format("{}.ckpt.{}", trajectory, slot);
}

std::string this_program() {
  return version() + " (" + revision() + ")";
}

/// Renames a checkpoint file that another run has left under this path. Otherwise --restart could mistake
/// this file for a checkpoint of the present run.
void rename_old_checkpoint(const std::string& path) {
  std::error_code failure;
  if (!std::filesystem::exists(path, failure)) return;
  std::filesystem::rename(path, path + ".old", failure);
  if (failure)
    throw SolverError(
        fmt::format("the file {} of an older run cannot be renamed: {}; rename or remove this file", path,
                    failure.message()));
}

/// Returns on all ranks whether the file exists for rank 0. Collective.
bool exists(const std::string& path, const Communicator& communicator) {
  std::error_code ignored;
  int there = communicator.is_root() && std::filesystem::exists(path, ignored) ? 1 : 0;
  MPI_Bcast(&there, 1, MPI_INT, 0, communicator.get());
  return there == 1;
}

IncomingMessage moment_of(const CheckpointReader& checkpoint) {
  return IncomingMessage(checkpoint.bytes(moment_section, 0, checkpoint.size(moment_section)));
}

std::unique_ptr<CheckpointReader> latest_complete_checkpoint(const std::string& trajectory,
                                                             const Communicator& communicator) {
  std::unique_ptr<CheckpointReader> last;
  std::string faults;
  for (const int slot : {0, 1}) {
    const std::string path = slot_path(trajectory, slot);
    if (!exists(path, communicator)) continue;
    try {
      auto checkpoint = std::make_unique<CheckpointReader>(path, communicator);
      if (!last || steps_done_in(*checkpoint) > steps_done_in(*last)) last = std::move(checkpoint);
    } catch (const InputError& damaged) {
      faults += std::string(damaged.what()) + "; ";
    }
  }
  if (!last) {
    throw InputError("--restart",
                     fmt::format("{0}{1} has no checkpoint to continue from: neither {1}.ckpt.0 nor "
                                 "{1}.ckpt.1 exists and is valid; write checkpoints with --checkpoint-every",
                                 faults, trajectory));
  }
  if (!faults.empty() && communicator.is_root())
    print_to_stderr(fmt::format("beadswim-run: {}continuing from the checkpoint {}\n", faults, last->path()));
  return last;
}

}  // namespace

std::string trajectory_of(const std::string& restart) {
  for (const int slot : {0, 1}) {
    const std::string end = slot_path("", slot);
    if (restart.ends_with(end)) return restart.substr(0, restart.size() - end.size());
  }
  return restart;
}

std::unique_ptr<CheckpointReader> open_checkpoint(const std::string& restart,
                                                  const Communicator& communicator) {
  if (trajectory_of(restart) == restart) return latest_complete_checkpoint(restart, communicator);
  if (!exists(restart, communicator))
    throw InputError(
        "--restart",
        fmt::format("the checkpoint {} does not exist; name FILE.h5md.ckpt.0, FILE.h5md.ckpt.1 or FILE.h5md",
                    restart));
  return std::make_unique<CheckpointReader>(restart, communicator);
}

std::unique_ptr<CheckpointReader> open_interrupted_run(const RunOptions& options, const std::string& layout,
                                                       const Communicator& communicator) {
  if (options.settings.model == RunModel::automatic) return nullptr;
  const bool is_there = exists(slot_path(options.output, 0), communicator) ||
                        exists(slot_path(options.output, 1), communicator);
  if (!is_there) return nullptr;
  try {
    auto checkpoint = latest_complete_checkpoint(options.output, communicator);
    FlagValues flags = flags_of(*checkpoint);
    require_same_result_flags(options, flags);
    for (const auto& [flag, value] : length_and_output_flags(options.settings))
      if (flag != "--checkpoint-every" && flags[flag] != value) return nullptr;
    const bool is_same =
        layout_of(*checkpoint) == layout && checkpoint->text(program_section) == this_program();
    return is_same ? std::move(checkpoint) : nullptr;
  } catch (const InputError&) {  // damaged, or of other flags
    return nullptr;
  }
}

FlagValues flags_of(const CheckpointReader& checkpoint) {
  try {
    auto flags = parse_json(checkpoint.text(flags_section), checkpoint.path()).get<FlagValues>();
    if (auto former = flags.extract("--tolerance")) {  // the flag's name in earlier versions
      former.key() = "--sum-tolerance";
      flags.insert(std::move(former));
    }
    return flags;
  } catch (const Json::exception&) {
    throw InputError(
        checkpoint.path(),
        "this version of the program cannot read the flags in the checkpoint; begin without --restart");
  }
}

void require_same_result_flags(const RunOptions& options, const FlagValues& flags) {
  for (const auto& [flag, value] : result_flags(options.settings)) {
    const auto of_checkpoint = flags.find(flag);
    const bool is_stored = of_checkpoint != flags.end();
    if (is_stored ? of_checkpoint->second == value : !options.given.contains(flag)) continue;
    throw InputError(flag, fmt::format("the value {} of the flag differs from {}, the value in the run of "
                                       "the checkpoint; leave the flag out, or begin without --restart",
                                       value, is_stored ? of_checkpoint->second : "the default"));
  }
}

std::string layout_of(const CheckpointReader& checkpoint) {
  return checkpoint.text(layout_section);
}

long steps_done_in(const CheckpointReader& checkpoint) {
  long steps_done = 0;
  moment_of(checkpoint)(steps_done);
  return steps_done;
}

RunHistory restore(Model& model, Recorder& recorder, const CheckpointReader& checkpoint,
                   const Communicator& communicator) {
  const std::string writer = checkpoint.text(program_section);
  if (writer != this_program() && communicator.is_root()) {
    print_to_stderr(
        fmt::format("beadswim-run: warning: the checkpoint {} was written by {}, but this program is {}; the "
                    "last bits of results may differ\n",
                    checkpoint.path(), writer, this_program()));
  }
  RunHistory history;
  IncomingMessage moment = moment_of(checkpoint);
  moment(history.steps_done);
  if (history.steps_done < 0)
    throw SolverError(checkpoint.path() +
                      ": the number of time steps in the checkpoint is negative, so the file is damaged; "
                      "take the run's other checkpoint (.ckpt.0 or .ckpt.1), or begin "
                      "without --restart");
  model.restore(history.steps_done, moment, checkpoint);
  moment(history.wall_seconds, history.core_seconds);
  if (!moment.is_at_end())
    throw SolverError(checkpoint.path() +
                      ": the checkpoint was written by another version of the program; continue with that "
                      "version, or begin without --restart");
  recorder.restore(communicator.is_root()
                       ? checkpoint.bytes(record_section, 0, checkpoint.size(record_section))
                       : std::vector<char>{},
                   history.steps_done);
  return history;
}

Checkpoints::Checkpoints(const RunOptions& options, std::string layout, const std::string& restarted,
                         const Communicator& communicator)
    : output_(options.output), layout_(std::move(layout)), communicator_(communicator) {
  FlagValues flags = result_flags(options.settings);
  flags.merge(length_and_output_flags(options.settings));
  flags_ = dump_json(Json(flags));
  last_ = restarted;
  int slot = communicator_.is_root() ? slot_of(restarted) : -1;
  MPI_Bcast(&slot, 1, MPI_INT, 0, communicator_.get());
  if (slot >= 0) {
    slot_ = 1 - slot;  // the next checkpoint must not overwrite that of --restart
  } else if (communicator_.is_root()) {
    for (const int other : {0, 1}) rename_old_checkpoint(slot_path(output_, other));
  }
}

int Checkpoints::slot_of(const std::string& checkpoint) const {
  std::error_code ignored;
  for (const int slot : {0, 1}) {
    if (!checkpoint.empty() && std::filesystem::equivalent(checkpoint, slot_path(output_, slot), ignored))
      return slot;
  }
  return -1;
}

void Checkpoints::write(const RunParts& parts, const RunHistory& history) {
  const std::vector<char> record = parts.recorder.state();
  OutgoingMessage moment;
  moment(history.steps_done);
  parts.model.write_history(moment);
  moment(history.wall_seconds, history.core_seconds);

  const std::string path = slot_path(output_, slot_);
  CheckpointWriter file(path, communicator_);
  file.add(program_section, this_program());
  file.add(flags_section, flags_);
  file.add(layout_section, layout_);
  file.add(moment_section, moment.bytes());
  parts.model.write_state(file);
  file.add(record_section, record);
  parts.trajectory.add_to(file);
  file.finish();
  last_ = path;
  slot_ = 1 - slot_;
}

}  // namespace beadswim
