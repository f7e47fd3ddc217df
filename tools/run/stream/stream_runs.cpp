#include "stream/stream_runs.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <thread>

#include "beadswim/core/error.hpp"
#include "beadswim/core/rank_failure.hpp"
#include "beadswim/core/sha256.hpp"
#include "beadswim/core/version.hpp"
#include "beadswim/documents/failure_document.hpp"
#include "beadswim/tools/program.hpp"
#include "beadswim/run/checkpoints.hpp"
#include "beadswim/tools/stop_signal.hpp"
#include "beadswim/tools/stream_jobs.hpp"
#include "one_run.hpp"
#include "stream/stream_plan.hpp"
#include "stream/stream_schedule.hpp"

namespace beadswim {
namespace {

/// Flags that change neither results nor records.
constexpr std::array same_result_flags{"--time-limit", "--progress", "--ranks-per-run", "--checkpoint-every"};

/// Counters on rank 0, which every rank may read and increase at any time.
class SharedCounters {
 public:
  enum Counter {
    claimed,   ///< layouts that a group has begun
    treated,   ///< millionths of layouts that have been treated
    finished,  ///< layouts that have been treated completely
    existing,  ///< of these: layouts whose records were there before
    stopped,   ///< ranks and groups that a signal or the time limit has stopped
    number_of_counters
  };

  explicit SharedCounters(const Communicator& communicator) {
    long* memory = nullptr;
    const MPI_Aint bytes = communicator.is_root() ? number_of_counters * sizeof(long) : 0;
    MPI_Win_allocate(bytes, sizeof(long), MPI_INFO_NULL, communicator.get(), &memory, &window_);
    if (communicator.is_root()) std::fill_n(memory, number_of_counters, 0);
    MPI_Win_lock_all(0, window_);
    MPI_Win_sync(window_);
    MPI_Barrier(communicator.get());
  }
  ~SharedCounters() {
    MPI_Win_unlock_all(window_);
    MPI_Win_free(&window_);
  }
  SharedCounters(const SharedCounters&) = delete;
  SharedCounters& operator=(const SharedCounters&) = delete;

  long value(Counter counter) { return add(counter, 0); }
  /// Adds a number to a counter. Returns its former value.
  long add(Counter counter, long number) {
    long former = 0;
    MPI_Fetch_and_op(&number, &former, MPI_LONG, 0, counter, MPI_SUM, window_);
    MPI_Win_flush(0, window_);
    return former;
  }

 private:
  MPI_Win window_ = MPI_WIN_NULL;
};

/// Options and names of files of the run of one layout, and the hash that identifies its record.
struct MemberRun {
  RunOptions options;
  std::string record_path;
  std::string request_sha256;
};

MemberRun member_run(const RunOptions& options, const LayoutDocument& document, int number) {
  MemberRun run{.options = options, .record_path = {}, .request_sha256 = {}};
  std::string& output = run.options.output;
  output.replace(output.find(number_mark), 2, std::to_string(number));
  run.record_path = std::filesystem::path(output).replace_extension(".json");
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

/// Returns the record of an earlier run of the same layout with the same flags, or the failure that this
/// command has written (check_files() removes earlier ones); null if there is none.
Json earlier_record(const MemberRun& run) {
  std::error_code ignored;
  if (!std::filesystem::exists(run.record_path, ignored)) return nullptr;
  Json record = parse_json(read_text(run.record_path), run.record_path);
  const bool is_same = record.value("request_sha256", Json()) == run.request_sha256;
  const bool is_complete = is_failure(record) || std::filesystem::exists(run.options.output, ignored);
  return is_same && is_complete ? record : Json();
}

void write_record(Json record, const MemberRun& run) {
  record["request_sha256"] = run.request_sha256;
  write_text(run.record_path, dump_json_line(record));
}

/// Prints records on rank 0 in the order of the layouts, up to the first layout without a record.
class RecordPrinter {
 public:
  RecordPrinter(const StoredLayouts& layouts, const RunOptions& options)
      : layouts_(layouts), options_(options) {}

  void print_available() {
    for (; printed_ < layouts_.size(); ++printed_) {
      const int number = printed_ + 1;
      const Json record = earlier_record(member_run(options_, layout_of(layouts_.member(number)), number));
      if (record.is_null()) return;
      write_text("-", dump_json_line(record));
      failed_ += record.value("status", "") != to_text(RunStatus::finished);
      warned_ += !record.value("warnings", Json::array()).empty();
    }
  }

  int printed() const { return printed_; }
  int failed() const { return failed_; }
  int warned() const { return warned_; }

 private:
  const StoredLayouts& layouts_;
  const RunOptions& options_;
  int printed_ = 0, failed_ = 0, warned_ = 0;
};

/// End of the work on a layout.
enum class MemberEnd {
  treated,
  existing,  ///< its record was there before
  stopped    ///< by a signal or the time limit
};

/// What a run of a stream asks and tells while it lasts.
struct MemberSinks {
  std::function<void(double)> share;                 ///< takes the share of the run that is done, on rank 0
  std::function<std::optional<StopRequest>()> stop;  ///< RunSinks::stop
  std::function<void()> failure;                     ///< RunSinks::failure
};

/// Runs the layout of a task and returns its record. Collective for the group.
RunResult run_task(RunTask& task, const RunOptions& options, const MemberSinks& member,
                   const Communicator& group) {
  const std::unique_ptr<ModelPlan> plan = plan_of(task, options, group);
  const auto steps = static_cast<double>(plan->steps_in(plan->settings.cycles));
  const RunSinks sinks{.message = print_message,
                       .progress = [&](long done) { member.share(static_cast<double>(done) / steps); },
                       .stop = member.stop,
                       .failure =
                           [&](const std::string& checkpoint) {
                             if (!checkpoint.empty())
                               print_message("the state is saved; repeat the command to continue");
                             member.failure();
                           }};
  return run(task, *plan, sinks, group);
}

/// Runs one layout, unless its record exists. Collective for the group.
MemberEnd run_member(const StreamMember& member, const RunOptions& options, const MemberSinks& sinks,
                     const Communicator& group) {
  RunTask task{.document = layout_of(member), .settings = options.settings, .source = member.source};
  const MemberRun wanted = member_run(options, task.document, member.number);
  task.trajectory = wanted.options.output;
  int is_done = group.is_root() && !earlier_record(wanted).is_null();
  MPI_Bcast(&is_done, 1, MPI_INT, 0, group.get());
  if (is_done) return MemberEnd::existing;
  // The record of other flags must not stay beside the trajectory that this run replaces.
  if (group.is_root()) std::filesystem::remove(wanted.record_path);
  task.checkpoint =
      open_interrupted_run(task.trajectory, dump_json(layout_to_json(task.document)), task.settings, group);
  if (task.checkpoint) task.steps_done = steps_done_in(*task.checkpoint);
  RunStatus status = RunStatus::failed;
  Json record;
  try {
    RunResult result = run_task(task, options, sinks, group);
    status = result.record.status;
    if (group.is_root()) {
      result.record.provenance->push_back(options.provenance);
      record = run_record_to_json(result.record, options.record_provenance());
    }
  } catch (const InputError& error) {
    record = failure_to_json({.program = program_name,
                              .member = member.number,
                              .reason = error.what(),
                              .study = task.document.study});
  }
  if (status == RunStatus::stopped_time || status == RunStatus::stopped_signal) return MemberEnd::stopped;
  if (group.is_root()) write_record(record, wanted);
  return MemberEnd::treated;
}

/// Work of all groups on the layouts of a stream.
class StreamRuns {
 public:
  /// `start`: MPI_Wtime from which --time-limit counts [s]. `has_progress`: true if this rank prints the
  /// progress. Collective.
  StreamRuns(const StoredLayouts& layouts, const RunOptions& options, double start, RecordPrinter& printer,
             bool has_progress, const Communicator& communicator, const Communicator& failures)
      : layouts_(layouts),
        options_(options),
        start_(start),
        printer_(printer),
        has_progress_(has_progress),
        communicator_(communicator),
        failures_(failures),
        progress_(program_name, layouts.size()),
        counters_(communicator) {}

  /// Runs all layouts, and prints their records. Returns true if a signal or the time limit stopped the work.
  /// If a rank fails, all ranks of the program are aborted. Collective.
  bool run(const StreamSchedule& schedule, const Communicator& group) {
    catch_stop_signals();
    try {
      run_side_by_side(schedule.side_by_side, group);
      for (const int number : schedule.on_all_ranks) {
        if (is_to_stop(communicator_)) break;
        run_one(number, communicator_);
      }
      if (communicator_.is_root()) printer_.print_available();
    } catch (...) {  // not rethrown: the destructor of the counters would wait for the other ranks
      abort_after_failure(program_name, failures_);
    }
    int stopped = communicator_.is_root() && is_stopped();
    MPI_Bcast(&stopped, 1, MPI_INT, 0, communicator_.get());
    return stopped != 0;
  }

 private:
  static constexpr long whole = 1000000;  ///< a layout [millionths]

  bool is_stopped() { return counters_.value(SharedCounters::stopped) > 0; }

  /// Stops the work of all groups after a signal to this rank.
  void stop_after_signal() {
    if (has_stopped_ || stop_signal() == 0) return;
    has_stopped_ = true;
    counters_.add(SharedCounters::stopped, 1);
  }

  /// Returns true, on all ranks of the group, if a signal or the time limit has stopped the work of any
  /// group. Collective for the group.
  bool is_to_stop(const Communicator& group) {
    stop_after_signal();
    int stopped = stop_signal() != 0;
    if (group.is_root()) {
      const double seconds = MPI_Wtime() - start_;
      if (seconds > options_.time_limit.value_or(seconds)) counters_.add(SharedCounters::stopped, 1);
      stopped = is_stopped();
    }
    MPI_Allreduce(MPI_IN_PLACE, &stopped, 1, MPI_INT, MPI_MAX, group.get());
    return stopped != 0;
  }

  /// Runs the layouts that no other group has begun. Collective.
  void run_side_by_side(const std::vector<int>& numbers, const Communicator& group) {
    const int count = static_cast<int>(numbers.size());
    while (!is_to_stop(group)) {
      int next = count;
      if (group.is_root())
        next = static_cast<int>(std::min<long>(counters_.add(SharedCounters::claimed, 1), count));
      MPI_Bcast(&next, 1, MPI_INT, 0, group.get());
      if (next == count) break;
      run_one(numbers[next], group);
    }
    wait_for_other_groups();
  }

  /// Runs the layout with this number, and counts it. Collective for the group.
  void run_one(int number, const Communicator& group) {
    long reported = 0;
    bool others_are_stopped = false;  // as rank 0 of the group knows
    double last = MPI_Wtime();
    const auto take_share = [&](double share) {
      constexpr double interval = 1;  // [s]
      if (MPI_Wtime() - last < interval) return;
      last = MPI_Wtime();
      const long now = std::lround(share * whole);
      counters_.add(SharedCounters::treated, now - reported);
      reported = now;
      others_are_stopped = is_stopped();
      print_news();
    };
    const auto stop = [&]() -> std::optional<StopRequest> {
      if (others_are_stopped) return StopRequest{.reason = "another run of the stream was stopped"};
      return stop_request(options_, start_, group);
    };
    const MemberSinks sinks{
        .share = take_share, .stop = stop, .failure = [&] { abort_after_failure(program_name, failures_); }};
    const MemberEnd end = run_member(layouts_.member(number), options_, sinks, group);
    if (!group.is_root()) return;
    if (end == MemberEnd::stopped) {
      counters_.add(SharedCounters::stopped, 1);
      return;
    }
    counters_.add(SharedCounters::treated, whole - reported);
    if (end == MemberEnd::existing) counters_.add(SharedCounters::existing, 1);
    counters_.add(SharedCounters::finished, 1);
    print_news();
  }

  /// Waits until all groups have no more work. Collective.
  void wait_for_other_groups() {
    MPI_Request all_wait = MPI_REQUEST_NULL;
    MPI_Ibarrier(communicator_.get(), &all_wait);
    for (int are_done = 0; !are_done; MPI_Test(&all_wait, &are_done, MPI_STATUS_IGNORE)) {
      stop_after_signal();
      print_news();
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
  }

  /// Prints new records and the progress, on rank 0.
  void print_news() {
    if (!communicator_.is_root()) return;
    if (const long finished = counters_.value(SharedCounters::finished); finished > seen_) {
      seen_ = finished;
      printer_.print_available();
    }
    if (has_progress_)
      progress_.update(static_cast<double>(counters_.value(SharedCounters::treated)) / whole,
                       static_cast<int>(counters_.value(SharedCounters::existing)));
  }

  const StoredLayouts& layouts_;
  const RunOptions& options_;
  double start_;
  RecordPrinter& printer_;
  bool has_progress_;
  const Communicator& communicator_;
  const Communicator& failures_;
  StreamProgress progress_;
  SharedCounters counters_;
  bool has_stopped_ = false;  ///< true: this rank has reported a signal
  long seen_ = 0;             ///< layouts whose records rank 0 has looked for
};

void check_flags(const StoredLayouts& layouts, const RunOptions& options) {
  if (!options.restart.empty()) throw InputError("--restart", "is for a single layout; leave it out");
  if (options.settings.model != RunModel::automatic)
    require_settings_apply(options.chosen, options.settings.model);
  if (options.plan) return;
  const std::size_t mark = options.output.find(number_mark);
  if (mark == std::string::npos || options.output.find(number_mark, mark + 1) != std::string::npos)
    throw InputError("--output", fmt::format("\"{}\": each of the {} layouts needs a trajectory of its own; "
                                             "write {{}} once in the name, for the number of the layout, "
                                             "such as -o run-{{}}.h5md",
                                             options.output, layouts.size()));
  if (!options.output.ends_with(".h5md"))
    throw InputError("--output",
                     fmt::format("\"{}\" does not end in .h5md; the record of each layout is written "
                                 "to the same name with .json in its place",
                                 options.output));
}

/// Removes failures of earlier commands, which are tried again. Throws InputError if a file that the stream
/// will write is one of its inputs, or if a file that a record would replace is no record.
void check_files(const StoredLayouts& layouts, const RunOptions& options) {
  namespace fs = std::filesystem;
  std::error_code ignored;
  for (int number = 1; number <= layouts.size(); ++number) {
    const MemberRun run = member_run(options, layout_of(layouts.member(number)), number);
    for (const std::string& path : {run.options.output, run.record_path})
      for (const std::string& input : options.layouts) require_other_file(input, path);
    if (!fs::exists(run.record_path, ignored)) continue;
    const Json found = parse_json(read_text(run.record_path), run.record_path);
    const Json schema = found.is_object() ? found.value("schema", Json("")) : Json("");
    if (is_failure(found)) {
      fs::remove(run.record_path);
    } else if (!schema.is_string() || !schema.get<std::string>().starts_with("beadswim/run/")) {
      throw InputError(run.record_path,
                       "this file is no run record, but the record of a layout would replace "
                       "it; move it, or give another name with -o");
    }
  }
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

/// Throws StoppedEarly or RunFailed on all ranks if not all layouts have a result. Collective.
void report(const RecordPrinter& printer, int layouts, bool is_stopped, const Communicator& communicator) {
  if (communicator.is_root() && printer.warned() > 0)
    print_to_stderr(
        fmt::format("{}: {} of {} layouts have warnings: see the key \"warnings\" of each record\n",
                    program_name, printer.warned(), layouts));
  std::array<int, 2> counts{printer.printed(), printer.failed()};
  MPI_Bcast(counts.data(), 2, MPI_INT, 0, communicator.get());
  const auto [printed, failed] = counts;
  if (is_stopped && printed < layouts)
    throw StoppedEarly(
        fmt::format("stopped by a signal or the time limit after the first {} of {} layouts; "
                    "the same command goes on, and keeps later results, too",
                    printed, layouts));
  if (printed < layouts)
    throw RunFailed(fmt::format(
        "the record of layout {} was removed while the stream ran; repeat the command", printed + 1));
  if (failed > 0)
    throw RunFailed(
        fmt::format("{} of {} layouts have no result or stopped early: see the key \"reason\" of "
                    "the records whose \"status\" is not \"finished\"",
                    failed, layouts));
}

}  // namespace

int run_stream(LayoutStream& stream, RunOptions options, double start, const Communicator& communicator,
               const Communicator& failures) {
  const StoredLayouts layouts(stream);
  check_flags(layouts, options);
  if (options.plan) {
    plan_stream(layouts, options, communicator);
    return static_cast<int>(ExitStatus::fine);
  }
  const StreamSchedule schedule = schedule_of(layouts, options, communicator);
  const bool has_progress = communicator.is_root() && options.progress != ProgressStyle::none;
  if (has_progress) announce(schedule, communicator);
  options.progress = ProgressStyle::none;
  std::string fault;
  if (communicator.is_root()) {
    try {
      check_files(layouts, options);
    } catch (const InputError& error) {
      fault = error.what();
    }
  }
  throw_together(fault, communicator);
  const std::unique_ptr<Communicator> group = group_of(schedule, communicator);
  RecordPrinter printer(layouts, options);
  const bool is_stopped = StreamRuns(layouts, options, start, printer, has_progress, communicator, failures)
                              .run(schedule, *group);
  report(printer, layouts.size(), is_stopped, communicator);
  return static_cast<int>(ExitStatus::fine);
}

}  // namespace beadswim
