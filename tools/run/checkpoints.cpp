#include "checkpoints.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>

#include "beadswim/core/error.hpp"
#include "beadswim/core/version.hpp"
#include "beadswim/coupling/swimmer_snapshot.hpp"
#include "beadswim/io/json.hpp"

namespace beadswim {
namespace {

constexpr const char* flags_section = "flags";
constexpr const char* program_section = "program";
constexpr const char* layout_section = "layout";
constexpr const char* moment_section = "moment";
constexpr const char* swimmers_section = "swimmers";
constexpr const char* record_section = "record";

std::string slot_path(const std::string& trajectory, int slot) {
  return fmt::format("{}.ckpt.{}", trajectory, slot);
}

/// Past: RunPast, const to write.
template <class Message, class Past>
void transfer_past(Message& message, Past& past) {
  message(past.moment.steps_done, past.moment.largest_bead_speed, past.moment.smallest_gap);
  message(past.first_totals.momentum, past.first_totals.mean_flow, past.first_totals.mass_excess);
  message(past.wall_seconds, past.core_seconds);
}

RunPast past_of(const CheckpointReader& checkpoint) {
  RunPast past;
  IncomingMessage message(checkpoint.bytes(moment_section, 0, checkpoint.size(moment_section)));
  transfer_past(message, past);
  if (!message.is_at_end()) throw SolverError(checkpoint.path() + ": is of another version of the program");
  return past;
}

std::string this_program() {
  return version() + " (" + revision() + ")";
}

LatticePart part_of(const CoupledSystem& system, const Communicator& communicator) {
  const Decomposition& decomposition = system.decomposition();
  const Block block = decomposition.block(communicator.rank());
  return {.cells = decomposition.cells(), .offset = block.offset, .size = block.size};
}

/// An older run's checkpoint, which a restart must not take for this run's.
void put_aside(const std::string& path) {
  std::error_code failure;
  if (!std::filesystem::exists(path, failure)) return;
  std::filesystem::rename(path, path + ".old", failure);
  if (failure)
    throw SolverError(fmt::format("{}, of an older run, cannot be renamed: {}", path, failure.message()));
}

/// Rank 0's look at the disk.
bool exists(const std::string& path, const Communicator& communicator) {
  std::error_code ignored;
  int there = communicator.is_root() && std::filesystem::exists(path, ignored) ? 1 : 0;
  MPI_Bcast(&there, 1, MPI_INT, 0, communicator.get());
  return there == 1;
}

/// The populations of one rank, as they are stored.
template <class Real>
void add_populations(CheckpointWriter& file, const CoupledSystem& system, const LatticePart& part) {
  const Populations& populations = system.populations();
  file.add_lattice<Real>(part, d3q19::directions, [&](int i, std::span<Real> numbers) {
    auto next = numbers.begin();
    for_each_cell(populations, [&](const Index3&, std::ptrdiff_t cell) {
      *next++ = static_cast<Real>(populations.outgoing(i, cell));
    });
  });
}

template <class Real>
void read_populations(const CheckpointReader& file, Populations& populations, const LatticePart& part) {
  file.read_lattice<Real>(part, d3q19::directions, [&](int i, std::span<const Real> numbers) {
    auto next = numbers.begin();
    for_each_cell(populations, [&](const Index3&, std::ptrdiff_t cell) {
      populations.set_outgoing(i, cell, static_cast<double>(*next++));
    });
  });
}

/// Of all swimmers, those that this rank owns, read some thousands at a time.
std::vector<SwimmerSnapshot> owned_swimmers(const CheckpointReader& file, const CoupledSystem& system) {
  const std::uint64_t all = file.size(swimmers_section), some = 4096 * snapshot_size();
  std::vector<SwimmerSnapshot> owned;
  for (std::uint64_t first = 0; first < all; first += some) {
    for (SwimmerSnapshot& swimmer :
         snapshots_from_bytes(file.bytes(swimmers_section, first, std::min(some, all - first)))) {
      if (system.owns(swimmer.state)) owned.push_back(std::move(swimmer));
    }
  }
  return owned;
}

std::unique_ptr<CheckpointReader> last_whole(const std::string& trajectory,
                                             const Communicator& communicator) {
  std::unique_ptr<CheckpointReader> last;
  std::string faults;
  for (const int slot : {0, 1}) {
    const std::string path = slot_path(trajectory, slot);
    if (!exists(path, communicator)) continue;
    try {
      auto checkpoint = std::make_unique<CheckpointReader>(path, communicator);
      if (!last || past_of(*checkpoint).moment.steps_done > past_of(*last).moment.steps_done)
        last = std::move(checkpoint);
    } catch (const InputError& damaged) {
      faults += std::string(damaged.what()) + "; ";
    }
  }
  if (!last) {
    throw InputError(
        "--restart",
        fmt::format("{}{} has no checkpoint to go on from; run with --checkpoint-every", faults, trajectory));
  }
  if (!faults.empty() && communicator.is_root())
    tell(fmt::format("beadswim-run: {}going on from {}\n", faults, last->path()));
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
  if (trajectory_of(restart) == restart) return last_whole(restart, communicator);
  if (!exists(restart, communicator)) throw InputError("--restart", restart + " does not exist");
  return std::make_unique<CheckpointReader>(restart, communicator);
}

FlagValues flags_of(const CheckpointReader& checkpoint) {
  return parse_json(checkpoint.text(flags_section), checkpoint.path()).get<FlagValues>();
}

void require_same_course(const RunOptions& options, const FlagValues& flags) {
  for (const auto& [flag, value] : course_of(options)) {
    const auto of_checkpoint = flags.find(flag);
    if (of_checkpoint == flags.end() || of_checkpoint->second == value) continue;
    throw InputError(flag,
                     fmt::format("{} is not {}, as of the checkpoint's run; leave it out, or begin anew "
                                 "without --restart",
                                 value, of_checkpoint->second));
  }
}

std::string layout_of(const CheckpointReader& checkpoint) {
  return checkpoint.text(layout_section);
}

long steps_in(const CheckpointReader& checkpoint) {
  return past_of(checkpoint).moment.steps_done;
}

RunPast restore(CoupledSystem& system, Recorder& recorder, const CheckpointReader& checkpoint,
                const Communicator& communicator) {
  const std::string writer = checkpoint.text(program_section);
  if (writer != this_program() && communicator.is_root()) {
    tell(
        fmt::format("beadswim-run: warning: {} was written by {}, and this is {}; the last bits may differ\n",
                    checkpoint.path(), writer, this_program()));
  }
  const RunPast past = past_of(checkpoint);
  const LatticePart part = part_of(system, communicator);
  system.restore(past.moment, owned_swimmers(checkpoint, system), [&](Populations& populations) {
    in_precision(populations.precision(),
                 [&]<class Real>() { read_populations<Real>(checkpoint, populations, part); });
  });
  recorder.restore(communicator.is_root()
                       ? checkpoint.bytes(record_section, 0, checkpoint.size(record_section))
                       : std::vector<char>{},
                   past.moment.steps_done);
  return past;
}

Checkpoints::Checkpoints(const RunOptions& options, std::string layout, const std::string& restarted,
                         const Communicator& communicator)
    : output_(options.output), layout_(std::move(layout)), communicator_(communicator) {
  FlagValues flags = course_of(options);
  flags.merge(length_and_outputs_of(options));
  flags_ = dump_json(Json(flags));
  last_ = restarted;
  int slot = communicator_.is_root() ? slot_of(restarted) : -1;
  MPI_Bcast(&slot, 1, MPI_INT, 0, communicator_.get());
  if (slot >= 0) {
    slot_ = 1 - slot;  // that one stays until the next is whole
  } else if (communicator_.is_root()) {
    for (const int other : {0, 1}) put_aside(slot_path(output_, other));
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

void Checkpoints::write(const RunParts& parts, const RunPast& past) {
  const std::vector<SwimmerSnapshot> swimmers = parts.system.gather_snapshots();
  const std::vector<char> record = parts.recorder.state();
  OutgoingMessage moment;
  transfer_past(moment, past);

  const std::string path = slot_path(output_, slot_);
  CheckpointWriter file(path, communicator_);
  file.add(program_section, this_program());
  file.add(flags_section, flags_);
  file.add(layout_section, layout_);
  file.add(moment_section, moment.bytes());
  file.add(swimmers_section, bytes_of(swimmers));
  file.add(record_section, record);
  parts.trajectory.add_to(file);
  const LatticePart part = part_of(parts.system, communicator_);
  in_precision(parts.system.populations().precision(),
               [&]<class Real>() { add_populations<Real>(file, parts.system, part); });
  file.finish();
  last_ = path;
  slot_ = 1 - slot_;
}

}  // namespace beadswim
