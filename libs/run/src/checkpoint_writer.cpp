#include "checkpoint_writer.hpp"

#include <filesystem>

#include "beadswim/core/data_error.hpp"
#include "beadswim/io/fields_json.hpp"
#include "checkpoint_sections.hpp"

namespace beadswim {
namespace {

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
  });
  return history;
}

Checkpoints::Checkpoints(const RunTask& task, const ModelPlan& plan, const Communicator& communicator)
    : trajectory_(task.trajectory),
      settings_(dump_json(Json(plan.settings))),
      layout_(dump_json(layout_to_json(task.document))),
      communicator_(communicator),
      last_(task.checkpoint ? task.checkpoint->path() : "") {
  int slot = communicator_.is_root() ? slot_of(last_) : -1;
  MPI_Bcast(&slot, 1, MPI_INT, 0, communicator_.get());
  if (slot >= 0) {
    slot_ = 1 - slot;  // the next checkpoint must not overwrite the one from which the run continues
  } else if (communicator_.is_root() && !trajectory_.empty()) {
    for (const int other : {0, 1}) rename_old_checkpoint(slot_path(trajectory_, other));
  }
}

int Checkpoints::slot_of(const std::string& checkpoint) const {
  std::error_code ignored;
  for (const int slot : {0, 1}) {
    if (!checkpoint.empty() && std::filesystem::equivalent(checkpoint, slot_path(trajectory_, slot), ignored))
      return slot;
  }
  return -1;
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
  parts.trajectory->add_to(file);
  file.finish();
  last_ = path;
  slot_ = 1 - slot_;
}

}  // namespace beadswim
