#include "run_parts.hpp"

#include <fmt/core.h>

#include <optional>

#include "beadswim/core/error.hpp"
#include "beadswim/core/round_up.hpp"

namespace beadswim {
namespace {

/// Number of time steps between checks for faults and requests to stop. These checks need communication of
/// all ranks.
constexpr long steps_between_guards = 20;

/// Number of time steps between checks of the total mass and momentum, which are also checked with every
/// frame.
constexpr long steps_between_totals = 500;

/// Returns the request to stop of the first rank that has one; nullopt if none has. The result is the same on
/// all ranks. Collective.
std::optional<EarlyStop> stop_request(const RunSinks& sinks, const Communicator& communicator) {
  std::optional<EarlyStop> request = sinks.stop ? sinks.stop() : std::nullopt;
  int first = request ? communicator.rank() : communicator.size();
  MPI_Allreduce(MPI_IN_PLACE, &first, 1, MPI_INT, MPI_MIN, communicator.get());
  if (first == communicator.size()) return std::nullopt;
  if (!request) request.emplace();
  broadcast(request->reason, communicator, first);
  MPI_Bcast(&request->status, sizeof(RunStatus), MPI_BYTE, first, communicator.get());
  return request;
}

/// Time steps at which outputs and checks are due. An interval of 0 means that the output is never due.
struct Timetable {
  long steps = 0, guard_interval = 0, totals_interval = 0, checkpoint_interval = 0;

  explicit Timetable(const ModelPlan& plan)
      : steps(plan.steps_in(plan.settings.cycles)),
        guard_interval(plan.whole_steps(steps_between_guards)),
        totals_interval(round_up_to_multiple(steps_between_totals, guard_interval)),
        checkpoint_interval(interval(plan, plan.settings.checkpoint_every)) {}

  bool is_last(long step) const { return step == steps; }
  bool is_checkpoint(long step) const {
    return checkpoint_interval > 0 && (is_last(step) || step % checkpoint_interval == 0);
  }
  bool is_guard(long step) const {
    return is_last(step) || is_checkpoint(step) || step % guard_interval == 0;
  }

 private:
  static long interval(const ModelPlan& plan, const std::optional<double>& cycles) {
    return cycles ? plan.whole_steps(steps_between(*cycles, plan.steps_per_cycle)) : 0;
  }
};

class TimeLoop {
 public:
  TimeLoop(const RunParts& parts, const std::optional<RunHistory>& history)
      : parts_(parts), history_(history.value_or(RunHistory{})), due_(parts.plan) {
    outcome_.last_totals = history ? parts.model.totals() : parts.model.first_totals();
    if (history) return;
    parts.recorder.sample(parts.model);
    parts.recorder.record(parts.model, outcome_.last_totals);  // the first frame of a new run
  }

  RunOutcome run() {
    while (step() < due_.steps && outcome_.status == RunStatus::finished) {
      parts_.model.step();
      parts_.recorder.sample(parts_.model);
      const bool is_guard = due_.is_guard(step()), is_frame = parts_.recorder.is_due(step());
      const bool is_flow = parts_.flow && parts_.flow->is_due(step());
      if (!is_guard && !is_frame && !is_flow) continue;
      if (!is_sound(is_frame)) break;
      if (is_frame) parts_.recorder.record(parts_.model, outcome_.last_totals);
      if (is_flow) parts_.flow->take(parts_.model);
      if (is_guard) guard();
    }
    outcome_.history = current_history();
    return outcome_;
  }

 private:
  long step() const { return parts_.model.steps_done(); }

  /// Returns true if no rank has found a fault. Otherwise stores the fault in the outcome. Also evaluates the
  /// totals of the scene if a frame, a checkpoint or the run record needs them.
  bool is_sound(bool is_frame) {
    ModelTotals totals = outcome_.last_totals;
    if (is_frame || due_.is_last(step()) || due_.is_checkpoint(step()) || step() % due_.totals_interval == 0)
      totals = parts_.model.totals();
    if (const std::optional<EarlyStop> fault = parts_.model.fault()) {
      outcome_.status = fault->status;
      outcome_.reason = fault->reason;
      return false;
    }
    outcome_.last_totals = totals;
    return true;
  }

  /// Stops the run if this is requested. Writes a checkpoint if one is due or if the run stops.
  void guard() {
    if (parts_.communicator.is_root() && parts_.sinks.progress) parts_.sinks.progress(step());
    bool is_checkpoint = due_.is_checkpoint(step());
    const std::optional<EarlyStop> stop =
        due_.is_last(step()) ? std::nullopt : stop_request(parts_.sinks, parts_.communicator);
    if (stop) {
      outcome_.status = stop->status;
      outcome_.reason = fmt::format("step {} of {}: {}", step(), due_.steps, stop->reason);
      outcome_.last_totals = parts_.model.totals();
      is_checkpoint = true;
    }
    if (is_checkpoint) parts_.checkpoints.write(parts_, current_history());
  }

  /// Returns steps and cost of this run until the present step, including the earlier runs that it continues.
  RunHistory current_history() const {
    const double seconds = MPI_Wtime() - start_;
    return {.steps_done = step(),
            .wall_seconds = history_.wall_seconds + seconds,
            .core_seconds = history_.core_seconds + seconds * parts_.communicator.size()};
  }

  const RunParts& parts_;
  RunHistory history_;
  Timetable due_;
  double start_ = MPI_Wtime();
  RunOutcome outcome_;
};

}  // namespace

RunOutcome run_to_end(const RunParts& parts, const std::optional<RunHistory>& history) {
  return TimeLoop(parts, history).run();
}

}  // namespace beadswim
