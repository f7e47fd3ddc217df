#include "stream/stream_runs.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <filesystem>

#include "beadswim/core/error.hpp"
#include "beadswim/core/rank_failure.hpp"
#include "beadswim/core/sha256.hpp"
#include "beadswim/core/version.hpp"
#include "beadswim/documents/failure_document.hpp"
#include "beadswim/run/checkpoints.hpp"
#include "beadswim/tools/program.hpp"
#include "beadswim/tools/stop_signal.hpp"
#include "one_run.hpp"
#include "request.hpp"

namespace beadswim {
namespace {

/// Flags that change neither results nor records.
constexpr std::array same_result_flags{"--time-limit", "--progress", "--ranks-per-run", "--checkpoint-every"};

/// Files of the run of one layout, and the hash that identifies its record.
struct MemberRun {
  std::string trajectory, record;
  std::string request_sha256;
};

MemberRun member_run(const RunOptions& options, const LayoutDocument& document, int number) {
  MemberRun run{.trajectory = options.output, .record = {}, .request_sha256 = {}};
  run.trajectory.replace(run.trajectory.find(number_mark), 2, std::to_string(number));
  run.record = std::filesystem::path(run.trajectory).replace_extension(".json");
  std::string text =
      version() + dump_json(layout_to_json({.layout = document.layout, .study = document.study}));
  for (const Json& argument : options.provenance.at("arguments")) {
    const std::string flag = argument.get<std::string>();
    const bool has_same_result = std::ranges::any_of(
        same_result_flags, [&](const char* name) { return flag.substr(0, flag.find('=')) == name; });
    if (!has_same_result) text += "\n" + flag;
  }
  Sha256 hash;
  hash.update(std::as_bytes(std::span(text)));
  run.request_sha256 = hash.hexadecimal();
  return run;
}

MemberResult result_of(const Json& record) {
  const bool is_warned = !record.value("warnings", Json::array()).empty();
  return {.line = dump_json_line(record),
          .findings = {.failed = record.value("status", "") != to_text(RunStatus::finished),
                       .warned = is_warned}};
}

/// Returns the record of an earlier run of the same layout with the same flags; nullopt if there is none.
/// Removes the failure of an earlier command, which is tried again. Throws InputError if a file that the run
/// will write is an input of the program, or if the file that the record would replace is no record.
std::optional<MemberResult> earlier_result(const StreamMember& member, const RunOptions& options) {
  std::error_code ignored;
  const MemberRun run = member_run(options, layout_of(member), member.number);
  for (const std::string& path : {run.trajectory, run.record})
    for (const std::string& input : options.layouts) require_other_file(input, path);
  if (!std::filesystem::exists(run.record, ignored)) return std::nullopt;
  const Json found = parse_json(read_text(run.record), run.record);
  if (is_failure(found)) {
    std::filesystem::remove(run.record);
    return std::nullopt;
  }
  const Json schema = found.is_object() ? found.value("schema", Json("")) : Json("");
  if (!schema.is_string() || !schema.get<std::string>().starts_with("beadswim/run/"))
    throw InputError(run.record,
                     "this file is no run record, but the record of a layout would replace it; move it, or "
                     "give another name with -o");
  const bool is_same = found.value("request_sha256", Json()) == run.request_sha256;
  return is_same && std::filesystem::exists(run.trajectory, ignored) ? std::optional(result_of(found))
                                                                     : std::nullopt;
}

/// Runs the layout of a task and returns its record, on rank 0 of the group. `failures`: communicator of all
/// ranks of the program. Collective for the group.
Json run_task(RunTask& task, const RunOptions& options, const RankGroup& group,
              const Communicator& failures) {
  const std::unique_ptr<ModelPlan> plan = plan_of(task, options, group.ranks);
  const auto steps = static_cast<double>(plan->steps_in(plan->settings.cycles));
  const RunSinks sinks{.message = print_message,
                       .progress = [&](long done) { group.progress(static_cast<double>(done) / steps); },
                       .stop = [&]() -> std::optional<EarlyStop> {
                         if (!group.is_to_stop()) return std::nullopt;
                         return EarlyStop{.reason = "the stream was stopped"};
                       },
                       .failure =
                           [&](const std::string& checkpoint) {
                             if (!checkpoint.empty())
                               print_message("the state is saved; repeat the command to continue");
                             abort_after_failure(program_name, failures);
                           }};
  RunRecord record = run(task, *plan, sinks, group.ranks).record;
  if (record.status == RunStatus::stopped_signal) throw StoppedEarly(record.reason);
  if (!group.ranks.is_root()) return {};
  record.provenance->push_back(options.provenance);
  return run_record_to_json(record, options.record_provenance());
}

/// Runs one layout and writes its record. Collective for the group.
MemberResult run_member(const StreamMember& member, const RunOptions& options, const RankGroup& group,
                        const Communicator& failures) {
  RunTask task{.document = layout_of(member), .settings = options.settings, .source = member.source};
  const MemberRun files = member_run(options, task.document, member.number);
  task.trajectory = files.trajectory;
  // The record of other flags must not stay beside the trajectory that this run replaces.
  if (group.ranks.is_root()) std::filesystem::remove(files.record);
  task.checkpoint = open_interrupted_run(task.trajectory, dump_json(layout_to_json(task.document)),
                                         task.settings, group.ranks);
  Json record;
  try {
    record = run_task(task, options, group, failures);
  } catch (const InputError& error) {
    record = Json::parse(failure_of(member, program_name, error.what()).line);
  }
  if (!group.ranks.is_root()) return {};
  record["request_sha256"] = files.request_sha256;
  const MemberResult result = result_of(record);
  write_text(files.record, result.line);
  return result;
}

void check_flags(const StoredStream& layouts, const RunOptions& options, const Communicator& communicator) {
  if (!options.restart.empty()) throw InputError("--restart", "is for a single layout; leave it out");
  if (options.ranks_per_run.value_or(1) > communicator.size())
    throw InputError(
        "--ranks-per-run",
        "{} is more than the {} ranks of this program; give a smaller number, or more ranks with mpirun -n",
        *options.ranks_per_run, communicator.size());
  if (options.settings.model != RunModel::automatic)
    require_settings_apply(options.chosen, options.settings.model);
  if (options.plan) return;
  const std::size_t mark = options.output.find(number_mark);
  if (mark == std::string::npos || options.output.find(number_mark, mark + 1) != std::string::npos)
    throw InputError("--output",
                     "\"{}\": each of the {} layouts needs a trajectory of its own; write {{}} once in the "
                     "name, for the number of the layout, such as -o run-{{}}.h5md",
                     options.output, layouts.size());
  if (!options.output.ends_with(".h5md"))
    throw InputError("--output",
                     "\"{}\" does not end in .h5md; the record of each layout is written to the same name "
                     "with .json in its place",
                     options.output);
}

void announce(const StreamSchedule& schedule, const Communicator& communicator) {
  const int small = static_cast<int>(schedule.side_by_side.size()),
            large = static_cast<int>(schedule.on_all_ranks.size());
  const auto ranks = [](int count) { return count == 1 ? "1 rank" : fmt::format("{} ranks", count); };
  std::string text = fmt::format("{}: {} layouts: ", program_name, small + large);
  if (small > 0)
    text += fmt::format("{} run side by side, up to {} at a time, each on {}", small,
                        std::min(small, schedule.groups(communicator)), ranks(schedule.ranks_per_run));
  if (large > 0)
    text += fmt::format("{}{} large, one after the other on all {}", small > 0 ? "; then " : "", large,
                        ranks(communicator.size()));
  print_to_stderr(text + "\n");
}

/// Throws StoppedEarly or RunFailed on all ranks if not all layouts have a result.
void report(const StreamTally& tally, int layouts, const Communicator& communicator) {
  const int taken = tally.taken, failed = tally.findings.failed;
  if (communicator.is_root() && tally.findings.warned > 0)
    print_message(fmt::format("{} of {} layouts have warnings: see the key \"warnings\" of each record",
                              tally.findings.warned, layouts));
  if (tally.is_stopped && taken < layouts)
    throw StoppedEarly(
        fmt::format("stopped by a signal or the time limit after the first {} of {} layouts; the same "
                    "command goes on, and keeps later results, too",
                    taken, layouts));
  if (taken < layouts)
    throw RunFailed(fmt::format(
        "the record of layout {} was removed while the stream ran; repeat the command", taken + 1));
  if (failed > 0)
    throw RunFailed(
        fmt::format("{} of {} layouts have no result or stopped early: see the key \"reason\" of the records "
                    "whose \"status\" is not \"finished\"",
                    failed, layouts));
}

}  // namespace

int run_stream(const StoredStream& layouts, RunOptions options, double start,
               const Communicator& communicator, const Communicator& failures) {
  check_flags(layouts, options, communicator);
  const StreamSchedule schedule = schedule_of(layouts, options.settings, options.ranks_per_run, communicator);
  if (options.plan) {
    plan_stream(layouts, options, schedule, communicator, failures);
    return static_cast<int>(ExitStatus::fine);
  }
  StreamSinks sinks{.program = program_name,
                    .take = [](int, const MemberResult& result) { write_text("-", result.line); },
                    .earlier = [&](int number) { return earlier_result(layouts.member(number), options); },
                    .stop = [&] { return stop_request(options, start).has_value(); },
                    .failure = [&] { abort_after_failure(program_name, failures); }};
  if (options.progress != ProgressStyle::none) {
    if (communicator.is_root()) announce(schedule, communicator);
    sinks.progress = print_message;
  }
  options.progress = ProgressStyle::none;
  catch_stop_signals();
  const auto work = [&](const StreamMember& member, const RankGroup& group) {
    return run_member(member, options, group, failures);
  };
  report(work_on_ranks(layouts, schedule, work, sinks, communicator), layouts.size(), communicator);
  return static_cast<int>(ExitStatus::fine);
}

}  // namespace beadswim
