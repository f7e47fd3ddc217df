#include "beadswim/run/checkpoints.hpp"

#include <fmt/core.h>

#include <filesystem>

#include "beadswim/core/error.hpp"
#include "beadswim/core/version.hpp"
#include "beadswim/io/fields_json.hpp"
#include "run_parts.hpp"

namespace beadswim {
namespace {

constexpr const char *settings_section = "settings", *program_section = "program", *layout_section = "layout",
                     *moment_section = "moment", *record_section = "record", *flow_section = "flow";

/// Returns the path of a checkpoint of a trajectory. `slot`: 0 or 1.
std::string slot_path(const std::string& trajectory, int slot) {
  return fmt::format("{}.ckpt.{}", trajectory, slot);
}

std::string this_program() {
  return version() + " (" + revision() + ")";
}

IncomingMessage moment_of(const CheckpointReader& checkpoint) {
  return IncomingMessage(checkpoint.bytes(moment_section));
}

/// Returns on all ranks whether the file exists for rank 0. Collective.
bool exists(const std::string& path, const Communicator& communicator) {
  std::error_code ignored;
  int there = communicator.is_root() && std::filesystem::exists(path, ignored) ? 1 : 0;
  MPI_Bcast(&there, 1, MPI_INT, 0, communicator.get());
  return there == 1;
}

std::unique_ptr<CheckpointReader> latest_complete_checkpoint(
    const std::string& trajectory, const std::function<void(const std::string&)>& message,
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
    throw InputError(Setting::restart,
                     "{0}{1} has no checkpoint to continue from: neither {1}.ckpt.0 nor {1}.ckpt.1 exists "
                     "and is valid; write checkpoints with {2}",
                     faults, trajectory, Setting::checkpoint_every);
  }
  if (!faults.empty() && message && communicator.is_root())
    message(fmt::format("{}continuing from the checkpoint {}", faults, last->path()));
  return last;
}

/// Renames a checkpoint file that another run has left under this path. Otherwise a restart could mistake
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

void warn_of_other_program(const RunParts& parts, const CheckpointReader& checkpoint) {
  const std::string writer = checkpoint.text(program_section);
  if (writer == this_program() || !parts.communicator.is_root() || !parts.sinks.message) return;
  parts.sinks.message(
      fmt::format("warning: the checkpoint {} was written by {}, but this program is {}; the last bits of "
                  "results may differ",
                  checkpoint.path(), writer, this_program()));
}

}  // namespace

void refuse_other_version(const CheckpointReader& checkpoint) {
  throw SolverError(
      fmt::format("{}: the checkpoint was written by another version of the program; continue with that "
                  "version, or begin without {}",
                  checkpoint.path(), Setting::restart));
}

std::string trajectory_of(const std::string& restart) {
  for (const int slot : {0, 1}) {
    const std::string end = slot_path("", slot);
    if (restart.ends_with(end)) return restart.substr(0, restart.size() - end.size());
  }
  return restart;
}

std::unique_ptr<CheckpointReader> open_checkpoint(const std::string& restart,
                                                  const std::function<void(const std::string&)>& message,
                                                  const Communicator& communicator) {
  if (trajectory_of(restart) == restart) return latest_complete_checkpoint(restart, message, communicator);
  if (!exists(restart, communicator))
    throw InputError(Setting::restart,
                     "the checkpoint {} does not exist; name FILE.h5md.ckpt.0, FILE.h5md.ckpt.1 or FILE.h5md",
                     restart);
  return std::make_unique<CheckpointReader>(restart, communicator);
}

std::unique_ptr<CheckpointReader> open_interrupted_run(const std::string& trajectory,
                                                       const std::string& layout, const RunSettings& settings,
                                                       const Communicator& communicator) {
  if (settings.model == RunModel::automatic) return nullptr;
  const bool is_there =
      exists(slot_path(trajectory, 0), communicator) || exists(slot_path(trajectory, 1), communicator);
  if (!is_there) return nullptr;
  try {
    auto checkpoint = latest_complete_checkpoint(trajectory, {}, communicator);
    const auto must_be_equal = [&](const SettingRow& row) {
      return applies(row, settings.model) && row.setting != Setting::checkpoint_every;
    };
    const bool is_same = !find_difference(settings, settings_of(*checkpoint), must_be_equal) &&
                         layout_of(*checkpoint) == layout &&
                         checkpoint->text(program_section) == this_program();
    return is_same ? std::move(checkpoint) : nullptr;
  } catch (const InputError&) {  // damaged
    return nullptr;
  }
}

RunSettings settings_of(const CheckpointReader& checkpoint) {
  try {
    return parse_json(checkpoint.text(settings_section), checkpoint.path()).get<RunSettings>();
  } catch (const Json::exception&) {
  } catch (const DataError&) {  // another version stored no settings
  }
  throw InputError(checkpoint.path(),
                   "this version of the program cannot read the settings in the checkpoint; begin without {}",
                   Setting::restart);
}

void require_same_results(const RunSettings& wanted, const RunSettings& present) {
  const auto must_be_equal = [&](const SettingRow& row) {
    return row.changes_results && applies(row, present.model);
  };
  if (const auto found = find_difference(wanted, present, must_be_equal))
    throw InputError(found->setting,
                     "the value {} differs from {}, the value in the run of the checkpoint; leave it out, or "
                     "begin without {}",
                     found->wanted, found->present, Setting::restart);
}

std::string layout_of(const CheckpointReader& checkpoint) {
  return checkpoint.text(layout_section);
}

void require_flow_sums(const ModelPlan& plan, const CheckpointReader& checkpoint) {
  with_checkpoint_remedy([&] { require_sums(*plan.flow, plan, checkpoint.bytes(flow_section)); });
}

long steps_done_in(const CheckpointReader& checkpoint) {
  long steps_done = 0;
  with_checkpoint_remedy([&] { moment_of(checkpoint)(steps_done); });
  return steps_done;
}

RunHistory restore(const RunParts& parts, const CheckpointReader& checkpoint) {
  warn_of_other_program(parts, checkpoint);
  RunHistory history;
  with_checkpoint_remedy([&] {
    IncomingMessage moment = moment_of(checkpoint);
    moment(history.steps_done);
    if (history.steps_done < 0)
      throw DataError(checkpoint.path(),
                      "the number of time steps in the checkpoint is negative, so the file is damaged");
    parts.model.restore(history.steps_done, moment, checkpoint);
    moment(history.wall_seconds, history.core_seconds);
    if (!moment.is_at_end()) refuse_other_version(checkpoint);
    parts.recorder.restore(
        parts.communicator.is_root() ? checkpoint.bytes(record_section) : std::vector<char>{},
        history.steps_done);
    if (parts.flow) parts.flow->restore(checkpoint.bytes(flow_section));
  });
  return history;
}

Checkpoints::Checkpoints(const RunTask& task, const ModelPlan& plan, const Communicator& communicator)
    : trajectory_(task.trajectory),
      settings_(dump_json(Json(plan.settings))),
      layout_(dump_json(layout_to_json(task.document))),
      communicator_(communicator),
      last_(task.checkpoint ? task.checkpoint->path() : "") {
  std::error_code ignored;
  int slot = -1;  // of the checkpoint from which the run continues; -1: it is no file of this run
  for (const int own : {0, 1})
    if (communicator_.is_root() && !last_.empty() &&
        std::filesystem::equivalent(last_, slot_path(trajectory_, own), ignored))
      slot = own;
  MPI_Bcast(&slot, 1, MPI_INT, 0, communicator_.get());
  if (slot >= 0) {
    slot_ = 1 - slot;  // the next checkpoint must not overwrite the one from which the run continues
  } else if (communicator_.is_root() && !trajectory_.empty()) {
    for (const int other : {0, 1}) rename_old_checkpoint(slot_path(trajectory_, other));
  }
}

void Checkpoints::write(const RunParts& parts, const RunHistory& history) {
  if (parts.trajectory == nullptr) return;
  const std::vector<char> record = parts.recorder.state();
  OutgoingMessage moment;
  moment(history.steps_done);
  parts.model.write_history(moment);
  moment(history.wall_seconds, history.core_seconds);
  const std::string path = slot_path(trajectory_, slot_);
  CheckpointWriter file(path, communicator_);
  file.add(program_section, this_program());
  file.add(settings_section, settings_);
  file.add(layout_section, layout_);
  file.add(moment_section, moment.bytes());
  parts.model.write_state(file);
  file.add(record_section, record);
  file.add(flow_section, parts.flow ? parts.flow->state() : std::vector<char>{});
  parts.trajectory->add_to(file);
  file.finish();
  last_ = path;
  slot_ = 1 - slot_;
}

}  // namespace beadswim
