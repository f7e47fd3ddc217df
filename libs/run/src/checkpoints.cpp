#include "beadswim/run/checkpoints.hpp"

#include <fmt/core.h>

#include <filesystem>

#include "beadswim/core/data_error.hpp"
#include "beadswim/io/fields_json.hpp"
#include "checkpoint_sections.hpp"

namespace beadswim {
namespace {

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
                     fmt::format("{0}{1} has no checkpoint to continue from: neither {1}.ckpt.0 nor "
                                 "{1}.ckpt.1 exists and is valid; write checkpoints with {2}",
                                 faults, trajectory, Setting::checkpoint_every));
  }
  if (!faults.empty() && message && communicator.is_root())
    message(fmt::format("{}continuing from the checkpoint {}", faults, last->path()));
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
                                                  const std::function<void(const std::string&)>& message,
                                                  const Communicator& communicator) {
  if (trajectory_of(restart) == restart) return latest_complete_checkpoint(restart, message, communicator);
  if (!exists(restart, communicator))
    throw InputError(
        Setting::restart,
        fmt::format("the checkpoint {} does not exist; name FILE.h5md.ckpt.0, FILE.h5md.ckpt.1 or FILE.h5md",
                    restart));
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
  const auto refuse = [&] {
    throw InputError(
        checkpoint.path(),
        fmt::format(
            "this version of the program cannot read the settings in the checkpoint; begin without {}",
            Setting::restart));
  };
  RunSettings settings;
  try {
    parse_json(checkpoint.text(settings_section), checkpoint.path()).get_to(settings);
  } catch (const Json::exception&) {
    refuse();
  } catch (const DataError&) {  // another version stored no settings
    refuse();
  }
  return settings;
}

void require_same_results(const RunSettings& wanted, const RunSettings& present) {
  const auto must_be_equal = [&](const SettingRow& row) {
    return row.changes_results && applies(row, present.model);
  };
  if (const auto found = find_difference(wanted, present, must_be_equal))
    throw InputError(
        found->setting,
        fmt::format("the value {} differs from {}, the value in the run of the checkpoint; leave it "
                    "out, or begin without {}",
                    found->wanted, found->present, Setting::restart));
}

std::string layout_of(const CheckpointReader& checkpoint) {
  return checkpoint.text(layout_section);
}

long steps_done_in(const CheckpointReader& checkpoint) {
  long steps_done = 0;
  with_checkpoint_remedy([&] { moment_of(checkpoint)(steps_done); });
  return steps_done;
}

}  // namespace beadswim
