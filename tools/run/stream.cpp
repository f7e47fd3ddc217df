#include "stream.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <filesystem>

#include "beadswim/core/error.hpp"
#include "beadswim/core/rank_failure.hpp"
#include "beadswim/core/sha256.hpp"
#include "beadswim/core/version.hpp"
#include "beadswim/documents/failure_document.hpp"
#include "beadswim/tools/program.hpp"
#include "beadswim/tools/stream_jobs.hpp"
#include "checkpoints.hpp"
#include "one_run.hpp"
#include "stop_signal.hpp"

namespace beadswim {
namespace {

/// Flags that change neither results nor records.
constexpr std::array same_result_flags{"--time-limit", "--progress", "--ranks-per-run", "--checkpoint-every"};

/// Returns the communicator of the ranks that run one layout together. Collective.
std::unique_ptr<Communicator> group_of(const Communicator& communicator, int ranks_per_run) {
  const int groups = communicator.size() / ranks_per_run;
  MPI_Comm own = MPI_COMM_NULL;
  MPI_Comm_split(communicator.get(), std::min(communicator.rank() / ranks_per_run, groups - 1),
                 communicator.rank(), &own);
  auto group = std::make_unique<Communicator>(own);
  MPI_Comm_free(&own);
  return group;
}

/// Counters on rank 0, which rank 0 of every group may read and raise at any time.
class SharedCounters {
 public:
  enum Counter { claimed, done, stopped, number_of_counters };

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

/// Runs one layout, unless its record exists. Returns false if a signal or the time limit stopped the run.
/// Collective for the group.
bool run_member(const StreamMember& member, const RunOptions& options, double start,
                const Communicator& group, const Communicator& failures) {
  const LayoutDocument document = layout_of(member);
  const MemberRun run = member_run(options, document, member.number);
  int is_done = group.is_root() && !earlier_record(run).is_null();
  MPI_Bcast(&is_done, 1, MPI_INT, 0, group.get());
  if (is_done) return true;
  // The record of other flags must not stay beside the trajectory that this run replaces.
  if (group.is_root()) std::filesystem::remove(run.record_path);
  Request request;
  request.options = run.options;
  request.name = member.source;
  request.checkpoint = open_interrupted_run(run.options, dump_json(layout_to_json(document)), group);
  if (request.checkpoint) request.steps_done = steps_done_in(*request.checkpoint);
  RunOutcome outcome;
  Json record;
  try {
    outcome = run_layout(
        document, request, start,
        [&](const RunRecord& made) { record = run_record_to_json(made, options.record_provenance()); }, group,
        failures);
  } catch (const InputError& error) {
    record = failure_to_json(
        {.program = program_name, .member = member.number, .reason = error.what(), .study = document.study});
  }
  if (outcome.status == RunStatus::stopped_time || outcome.status == RunStatus::stopped_signal) return false;
  if (group.is_root()) write_record(record, run);
  return true;
}

/// Returns the number of ranks of each group: that of --ranks-per-run, or as few as keep all ranks busy.
int ranks_per_run(const RunOptions& options, int layouts, int ranks) {
  if (!options.ranks_per_run) return std::max(1, ranks / layouts);
  if (*options.ranks_per_run <= ranks) return *options.ranks_per_run;
  throw InputError("--ranks-per-run", fmt::format("{} is more than the {} ranks of this program; give a "
                                                  "smaller number, or more ranks with mpirun -n",
                                                  *options.ranks_per_run, ranks));
}

void check_flags(const StoredLayouts& layouts, const RunOptions& options) {
  refuse_flags(options, {"--restart", "--plan"}, "is for a single layout; leave it out");
  if (options.settings.model != RunModel::automatic)
    refuse_flags_of_other_models(options, options.settings.model);
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

/// Runs the layouts that no other group has begun, and prints the records that are there. Returns true if a
/// signal or the time limit stopped a run. If a rank fails, all ranks of the program are aborted. Collective.
bool run_members(const StoredLayouts& layouts, const RunOptions& options, double start,
                 RecordPrinter& printer, bool has_progress, const Communicator& group,
                 const Communicator& communicator, const Communicator& failures) {
  StreamProgress progress(program_name, layouts.size());
  bool is_stopped = false;
  SharedCounters counters(communicator);
  try {
    while (!is_stopped) {
      int number = 0;
      if (group.is_root()) {
        const bool is_end = counters.add(SharedCounters::stopped, 0) > 0;
        number = is_end ? layouts.size() + 1 : static_cast<int>(counters.add(SharedCounters::claimed, 1)) + 1;
      }
      MPI_Bcast(&number, 1, MPI_INT, 0, group.get());
      if (number > layouts.size()) break;
      is_stopped = !run_member(layouts.member(number), options, start, group, failures);
      if (!group.is_root()) continue;
      const long done = counters.add(is_stopped ? SharedCounters::stopped : SharedCounters::done, 1) + 1;
      if (is_stopped || !communicator.is_root()) continue;
      printer.print_available();
      if (has_progress) progress.update(static_cast<int>(done));
    }
    MPI_Allreduce(MPI_IN_PLACE, &is_stopped, 1, MPI_C_BOOL, MPI_LOR, communicator.get());
    if (communicator.is_root()) printer.print_available();
  } catch (...) {  // not rethrown: the destructor of the counters would wait for the other ranks
    abort_after_failure(program_name, failures);
  }
  return is_stopped;
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
  if (is_stopped)
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

int run_stream(LayoutStream& stream, const Request& request, double start, const Communicator& communicator,
               const Communicator& failures) {
  const StoredLayouts layouts(stream);
  RunOptions options = request.options;
  check_flags(layouts, options);
  const int per_run = ranks_per_run(options, layouts.size(), communicator.size());
  const bool has_progress = communicator.is_root() && options.progress != ProgressStyle::none;
  if (has_progress)
    print_to_stderr(fmt::format("{}: {} layouts, {} at a time, {} ranks for each\n", program_name,
                                layouts.size(), communicator.size() / per_run, per_run));
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
  const std::unique_ptr<Communicator> group = group_of(communicator, per_run);
  RecordPrinter printer(layouts, options);
  const bool is_stopped =
      run_members(layouts, options, start, printer, has_progress, *group, communicator, failures);
  report(printer, layouts.size(), is_stopped, communicator);
  return static_cast<int>(ExitStatus::fine);
}

}  // namespace beadswim
