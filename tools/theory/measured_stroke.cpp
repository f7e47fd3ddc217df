#include "measured_stroke.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "beadswim/core/error.hpp"

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

}  // namespace

MeasuredStroke read_measured_stroke(const std::string& path, std::optional<int> swimmer) {
  const RunRecord run = read_run_record(path);
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
