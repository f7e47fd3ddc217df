#include <fmt/core.h>

#include <algorithm>
#include <numeric>
#include <optional>

#include "beadswim/core/rank_failure.hpp"
#include "beadswim/documents/layout_document.hpp"
#include "beadswim/plan/run_plan.hpp"
#include "one_run.hpp"
#include "stream/stream_runs.hpp"

namespace beadswim {
namespace {

/// Costs of the cheapest runs of all layouts.
struct StreamCosts {
  double core_seconds = 0, output_bytes = 0;
  double max_memory_bytes = 0;  ///< memory of the largest run

  void add(const PlannedRun& run) {
    core_seconds += run.core_seconds;
    output_bytes += run.output_bytes;
    max_memory_bytes = std::max(max_memory_bytes, run.memory_bytes);
  }

  /// Combines the costs of all ranks. Collective.
  void combine(const Communicator& communicator) {
    for (double* sum : {&core_seconds, &output_bytes})
      MPI_Allreduce(MPI_IN_PLACE, sum, 1, MPI_DOUBLE, MPI_SUM, communicator.get());
    MPI_Allreduce(MPI_IN_PLACE, &max_memory_bytes, 1, MPI_DOUBLE, MPI_MAX, communicator.get());
  }
};

/// Plans one layout, and adds the cost of its run to the costs of the group. The note of the result is a row
/// of the table, or the reason why there is no run. Collective for the group.
MemberResult plan_member(const StreamMember& member, const RunOptions& options,
                         const std::optional<LatticeSpeed>& speed, const Communicator& group,
                         StreamCosts& costs) {
  const LayoutDocument document = layout_of(member);
  PlanRequest request = plan_request(options, group);
  if (speed) request.lattice_speed = [&speed] { return *speed; };
  const RunPlan plan = plan_run(document.layout, request, member.source, group);
  if (!group.is_root()) return {};
  Json json = plan_to_json(plan, "-");
  if (options.with_provenance) json["provenance"] = Json::array({options.provenance});
  if (!document.study.is_null()) json["study"] = document.study;
  MemberResult result{.line = dump_json_line(json)};
  if (plan.choice || (plan.best && !options.tolerance)) {
    const PlannedRun& choice = choose_run(plan);
    costs.add(choice);
    result.note = plan_row(plan, choice, study_text(document.study, 4));
    return result;
  }
  result.findings.failed = 1;
  if (plan.best) {
    const PlannedRun& best = plan.runs[*plan.best];
    result.note = fmt::format("no run within {}; smallest error: {}, {}", in_percent(plan.tolerance),
                              settings_text(best.settings, options.chosen),
                              in_percent(best.errors.limits.total.largest()));
  } else {
    result.note = "no model can run this layout; see \"refused\" in its plan";
  }
  return result;
}

/// Returns the speed of the lattice with the ranks of a group, measured by one group if it is not known yet;
/// nullopt if no run has a lattice. Collective.
std::optional<LatticeSpeed> common_lattice_speed(const RunOptions& options, const StreamSchedule& schedule,
                                                 const Communicator& communicator) {
  const RunModel model = options.settings.model;
  if (model != RunModel::automatic && model != RunModel::lbm) return std::nullopt;
  const std::unique_ptr<Communicator> group = group_of(schedule, communicator);
  std::string text;
  if (schedule.own_group(communicator) == 0)
    text = lattice_speed_to_json(speed_of_this_machine(print_message, *group)).dump();
  broadcast(text, communicator);
  return lattice_speed_from_json(Json::parse(text));
}

/// Prints the plan, and the row of the table.
void print(int number, const MemberResult& result) {
  write_text("-", result.line);
  print_to_stderr(result.findings.failed ? fmt::format("{:>8}  {}\n", number, result.note)
                                         : fmt::format("{:>8}{}", number, result.note));
}

}  // namespace

void plan_stream(const StoredStream& layouts, const RunOptions& options, StreamSchedule schedule,
                 const Communicator& communicator, const Communicator& failures) {
  schedule.side_by_side.resize(layouts.size());
  std::iota(schedule.side_by_side.begin(), schedule.side_by_side.end(), 1);
  schedule.on_all_ranks.clear();
  const std::optional<LatticeSpeed> speed = common_lattice_speed(options, schedule, communicator);
  if (communicator.is_root()) print_to_stderr(fmt::format("{:>8}\n{}", "layout", plan_head("        ")));
  StreamCosts costs;
  const auto work = [&](const StreamMember& member, const RankGroup& group) {
    return plan_member(member, options, speed, group.ranks, costs);
  };
  const StreamSinks sinks{.program = program_name, .take = print, .failure = [&] {
                            abort_after_failure(program_name, failures);
                          }};
  const StreamTally tally = work_on_ranks(layouts, schedule, work, sinks, communicator);
  costs.combine(communicator);
  const int failed = tally.findings.failed;
  const char* condition = options.tolerance ? " within the tolerance" : "";
  if (communicator.is_root())
    print_to_stderr(fmt::format(
        "all: {} of {} layouts have a run{}; together {:.3g} core-seconds, "
        "{:.3g} s on the ranks of this command ({}), {} of output, at most {} of memory per run\n",
        layouts.size() - failed, layouts.size(), condition, costs.core_seconds,
        costs.core_seconds / communicator.size(), communicator.size(), size_text(costs.output_bytes),
        size_text(costs.max_memory_bytes)));
  if (failed > 0)
    throw RunFailed(
        fmt::format("{} of {} layouts have no run{}: see the keys \"best\" and \"reason\" of the lines",
                    failed, layouts.size(), condition));
}

}  // namespace beadswim
