#include "swarm_values.hpp"

#include <algorithm>

#include "beadswim/core/error.hpp"
#include "beadswim/documents/swimming_document.hpp"
#include "beadswim/documents/trajectory_file.hpp"

namespace beadswim {
namespace {

/// Throws InputError if the file is not one run record of a run with these swimmers.
RunRecord read_record(const std::string& path, const RunRecord& trajectory) {
  const std::vector<SourceJson> documents = read_json_documents(path, "a run record");
  RunRecord run = run_from_json(documents.front().json, documents.front().source);
  if (documents.size() > 1 || run.units != trajectory.units || !(run.driving == trajectory.driving) ||
      swimmers_of(run) != swimmers_of(trajectory))
    throw InputError(path,
                     "this is not the record of the run whose trajectory is drawn; give one record, "
                     "of the same run");
  return run;
}

std::optional<double> last_value(const RunRecord& run, const SwimmerRecord& swimmer, ResultQuantity quantity,
                                 double time) {
  constexpr double roundoff = 1e-9;  // of times, relative to the period
  const double periods = time / swimmer.period.value_or(run.driving.period);
  const auto has_ended = [&](const CycleStatistics& cycle) { return cycle.index <= periods + roundoff; };
  const auto after = std::ranges::partition_point(swimmer.cycles, has_ended);
  if (after == swimmer.cycles.begin()) return std::nullopt;
  const CycleChoice choice{CycleChoice::Kind::index, std::prev(after)->index};
  return number_of(results_of(run, swimmer, choice, ""), quantity);
}

}  // namespace

std::vector<std::optional<double>> last_values(ResultQuantity quantity, const std::string& trajectory,
                                               const std::string& record, double time,
                                               const std::vector<int>& ids) {
  if (row_of(quantity).is_per_arm)
    throw InputError("--colour", "{} has a value per arm, but a swimmer has one colour; name another result",
                     to_text(quantity));
  RunRecord run = run_of_trajectory(trajectory);
  if (!record.empty()) run = read_record(record, run);
  std::vector<std::optional<double>> values;
  for (const int id : ids)
    values.push_back(last_value(run, find_swimmer(run, id, trajectory), quantity, time));
  if (std::ranges::any_of(values, [](const auto& value) { return value.has_value(); })) return values;
  throw InputError("--colour", "{} states no {} of a cycle that has ended at this frame{}",
                   record.empty() ? trajectory : record, to_text(quantity),
                   record.empty() ? "; add the run record as a second file, or draw a later frame"
                                  : "; name another result, or draw a later frame");
}

}  // namespace beadswim
