#include "measured_stroke.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "beadswim/core/error.hpp"
#include "beadswim/documents/failure_document.hpp"
#include "beadswim/io/document_stream.hpp"

namespace beadswim {
namespace {

const SwimmerRecord& find_swimmer_record(const RunRecord& run, std::optional<int> id,
                                         const std::string& path) {
  const auto is_requested = [&](const SwimmerRecord& swimmer) { return !id || swimmer.id == *id; };
  const auto found = std::find_if(run.swimmers.begin(), run.swimmers.end(), is_requested);
  if (found != run.swimmers.end()) return *found;
  if (run.swimmers.empty()) {
    throw InputError(
        "--stroke-from " + path,
        fmt::format("the run record contains only statistics of the swarm, because the run has more than {} "
                    "swimmers; run a smaller cell of the scene (beadswim-layout reduce)",
                    max_swimmers_listed));
  }
  const std::string which = id ? fmt::format("swimmer {}", *id) : "swimmers one by one";
  throw InputError(
      "--stroke-from " + path,
      fmt::format("the run record does not list {}, but only {} other swimmers; give a swimmer of the record",
                  which, run.swimmers.size()));
}

/// Returns the only run of a file that has a stroke. Counts other documents on standard error.
RunRecord run_with_stroke(const std::string& path) {
  DocumentStream documents({path});
  std::vector<RunRecord> runs;
  int count = 0;
  for (; const auto member = documents.next(); ++count) {
    const Json json = parse_json(member->text, member->source);
    if (is_failure(json)) continue;
    RunRecord run = run_record_from_json(json, member->source);
    const auto has_cycle = [](const SwimmerRecord& swimmer) { return !swimmer.cycles.empty(); };
    if (documents.is_single() || std::ranges::any_of(run.swimmers, has_cycle)) runs.push_back(std::move(run));
  }
  if (runs.size() != 1)
    throw InputError("--stroke-from " + path,
                     fmt::format("{} of {} documents are runs with a complete cycle; "
                                 "give the record of one such run",
                                 runs.size(), count));
  if (count > 1)
    print_to_stderr(
        fmt::format("beadswim-theory: {} of {} documents of {} have no result, and are left out\n", count - 1,
                    count, path));
  return std::move(runs.front());
}

}  // namespace

MeasuredStroke read_measured_stroke(const std::string& path, std::optional<int> swimmer) {
  const RunRecord run = run_with_stroke(path);
  const SwimmerRecord& record = find_swimmer_record(run, swimmer, path);
  if (record.cycles.empty()) {
    throw InputError("--stroke-from " + path,
                     fmt::format("swimmer {} has not finished a cycle; run at least one cycle", record.id));
  }
  const CycleStatistics& last = record.cycles.back();
  if (last.arm_amplitudes.size() != 2)
    throw InputError(
        "--stroke-from " + path,
        fmt::format("swimmer {} has {} bonds, but the methods need the stroke of two arms; give a "
                    "run of the paper's three-bead swimmer",
                    record.id, last.arm_amplitudes.size()));
  return {.source = path,
          .units = run.units,
          .period = record.period.value_or(run.driving.period),
          .stroke = {.amplitude = {last.arm_amplitudes[0], last.arm_amplitudes[1]},
                     .phase = {last.arm_phases[0], last.arm_phases[1]}}};
}

}  // namespace beadswim
