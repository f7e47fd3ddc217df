#include "stream/stream_plan.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <optional>

#include "beadswim/core/error.hpp"
#include "beadswim/documents/failure_document.hpp"
#include "beadswim/documents/study_text.hpp"
#include "beadswim/plan/lattice_speed_cache.hpp"
#include "beadswim/plan/plan_report.hpp"
#include "beadswim/run/percent.hpp"
#include "one_run.hpp"

namespace beadswim {
namespace {

/// The plan of one layout as text, and its run as choose_run() returns it.
struct MemberPlan {
  std::string document;  ///< line of JSON
  std::string row;       ///< row of the table
  std::optional<PlannedRun> choice;
};

/// Costs of the cheapest runs of all layouts.
struct StreamCosts {
  int runs = 0;  ///< number of layouts with a run
  double core_seconds = 0, output_bytes = 0;
  double max_memory_bytes = 0;  ///< memory of the largest run

  void add(const PlannedRun& run) {
    ++runs;
    core_seconds += run.core_seconds;
    output_bytes += run.output_bytes;
    max_memory_bytes = std::max(max_memory_bytes, run.memory_bytes);
  }

  /// Combines the costs of all ranks. Collective.
  void combine(const Communicator& communicator) {
    MPI_Allreduce(MPI_IN_PLACE, &runs, 1, MPI_INT, MPI_SUM, communicator.get());
    for (double* sum : {&core_seconds, &output_bytes})
      MPI_Allreduce(MPI_IN_PLACE, sum, 1, MPI_DOUBLE, MPI_SUM, communicator.get());
    MPI_Allreduce(MPI_IN_PLACE, &max_memory_bytes, 1, MPI_DOUBLE, MPI_MAX, communicator.get());
  }
};

/// Plans one layout. Collective for the group.
MemberPlan plan_member(const StreamMember& member, const RunOptions& options,
                       const std::optional<LatticeSpeed>& speed, const Communicator& group) {
  const LayoutDocument document = layout_of(member);
  MemberPlan made;
  const auto refuse = [&](const std::string& reason) {
    made.row = fmt::format("{:>8}  {}\n", member.number, reason);
  };
  try {
    PlanRequest request = plan_request(options, group);
    if (speed) request.lattice_speed = [&speed] { return *speed; };
    const RunPlan plan = plan_run(document.layout, request, member.source, group);
    Json json = plan_to_json(plan, "-");
    if (options.with_provenance) json["provenance"] = Json::array({options.provenance});
    if (!document.study.is_null()) json["study"] = document.study;
    made.document = dump_json_line(json);
    if (plan.choice || (plan.best && !options.tolerance)) {
      made.choice = choose_run(plan);
      made.row = fmt::format("{:>8}{}", member.number,
                             plan_row(plan, *made.choice, study_text(document.study, 4)));
    } else if (plan.best) {
      const PlannedRun& best = plan.runs[*plan.best];
      refuse(fmt::format("no run within {}; smallest error: {}, {}", in_percent(plan.tolerance),
                         settings_text(best.settings, options.chosen), in_percent(best.error.limit.largest())));
    } else {
      refuse("no model can run this layout; see \"refused\" in its plan");
    }
  } catch (const InputError& error) {
    refuse(error.what());
    made.document = failure_line(
        {.program = program_name, .member = member.number, .reason = error.what(), .study = document.study});
  }
  return made;
}

/// Returns the speed of the lattice with the ranks of a group, measured by one group if it is not known yet;
/// nullopt if no run has a lattice. Collective.
std::optional<LatticeSpeed> common_lattice_speed(const RunOptions& options, bool measures,
                                                 const Communicator& group,
                                                 const Communicator& communicator) {
  const RunModel model = options.settings.model;
  if (model != RunModel::automatic && model != RunModel::lbm) return std::nullopt;
  std::string text;
  if (measures) text = lattice_speed_to_json(speed_of_this_machine(print_message, group)).dump();
  broadcast(text, communicator);
  return lattice_speed_from_json(Json::parse(text));
}

/// Returns the texts of all ranks, one after the other, on rank 0. Collective.
std::string gather_text(const std::string& own, const Communicator& communicator) {
  const std::vector<char> all = gather_bytes({own.begin(), own.end()}, communicator);
  return {all.begin(), all.end()};
}

}  // namespace

void plan_stream(const StoredLayouts& layouts, const RunOptions& options, const Communicator& communicator) {
  const StreamSchedule schedule = schedule_of(layouts, options, communicator);
  const std::unique_ptr<Communicator> group = group_of(schedule, communicator);
  const int groups = schedule.groups(communicator), own_group = schedule.own_group(communicator);
  const std::optional<LatticeSpeed> speed =
      common_lattice_speed(options, own_group == 0, *group, communicator);
  const bool prints = communicator.is_root();
  if (prints) print_to_stderr(fmt::format("{:>8}\n{}", "layout", plan_head("        ")));
  StreamCosts costs;
  for (int first = 1; first <= layouts.size(); first += groups) {
    MemberPlan made;
    if (const int number = first + own_group; number <= layouts.size())
      made = plan_member(layouts.member(number), options, speed, *group);
    if (!group->is_root()) made = {};
    const std::string documents = gather_text(made.document, communicator);
    const std::string rows = gather_text(made.row, communicator);
    if (prints) {
      write_text("-", documents);
      print_to_stderr(rows);
    }
    if (made.choice) costs.add(*made.choice);
  }
  costs.combine(communicator);
  if (prints)
    print_to_stderr(fmt::format(
        "all: {} of {} layouts have a run{}; together {:.3g} core-seconds, "
        "{:.3g} s on the ranks of this command ({}), {} of output, at most {} of memory per run\n",
        costs.runs, layouts.size(), options.tolerance ? " within the tolerance" : "", costs.core_seconds,
        costs.core_seconds / communicator.size(), communicator.size(), size_text(costs.output_bytes),
        size_text(costs.max_memory_bytes)));
  if (costs.runs < layouts.size())
    throw RunFailed(fmt::format(
        "{} of {} layouts have no run{}: see the keys \"best\" and \"reason\" of the lines",
        layouts.size() - costs.runs, layouts.size(), options.tolerance ? " within the tolerance" : ""));
}

}  // namespace beadswim
