#include "run_loop.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "beadswim/core/error.hpp"
#include "beadswim/coupling/conservation.hpp"
#include "checkpoints.hpp"
#include "fault_message.hpp"
#include "stop_signal.hpp"

namespace beadswim {
namespace {

/// Steps between looks at what may stop the run: ranks agree there, and only there.
constexpr long steps_between_guards = 20;

/// Steps after which the fluid's totals are looked at even if no frame is due.
constexpr long steps_between_totals = 500;

struct Stop {
  RunStatus status;
  std::string reason;
};

/// Why the run should stop here although nothing is wrong: a signal to any rank, or the time limit by rank
/// 0's clock. The same answer on all ranks.
std::optional<Stop> asked_to_stop(double start, const RunOptions& options, const Communicator& communicator) {
  const double seconds = MPI_Wtime() - start;
  std::array<int, 2> asked{stop_signal(),
                           communicator.is_root() && seconds > options.time_limit.value_or(seconds)};
  MPI_Allreduce(MPI_IN_PLACE, asked.data(), asked.size(), MPI_INT, MPI_MAX, communicator.get());
  if (asked[0] != 0) return Stop{RunStatus::stopped_signal, fmt::format("stopped by signal {}", asked[0])};
  if (asked[1] == 0) return std::nullopt;
  return Stop{
      RunStatus::stopped_time,
      fmt::format("the time limit of {} s is over; a longer --time-limit, or more ranks, take the run "
                  "to its end",
                  *options.time_limit)};
}

/// What totals say has gone wrong, if anything.
std::optional<Fault> loss_in(const CoupledSystem& system, const SceneOnLattice& on_lattice,
                             const SceneTotals& first, const SceneTotals& now) {
  auto fault = conservation_fault(on_lattice.scene, first, now, system.largest_bead_speed());
  if (fault) fault->step = system.steps_done();
  return fault;
}

}  // namespace

long total_steps(const SceneOnLattice& on_lattice, const RunOptions& options) {
  const double steps = options.cycles * static_cast<double>(on_lattice.lattice.steps_per_period);
  constexpr double most = 1e15;  // counted exactly in doubles, and out of reach
  if (steps > most) {
    throw InputError("--cycles", fmt::format("{:.3g} cycles are {:.3g} steps; at most {:.3g}", options.cycles,
                                             steps, most));
  }
  return std::max(1L, std::lround(steps));
}

long steps_between(const SceneOnLattice& on_lattice, double cycles) {
  constexpr double never = 1e15;
  const double steps = cycles * static_cast<double>(on_lattice.lattice.steps_per_period);
  return std::max(1L, std::lround(std::min(steps, never)));
}

RunOutcome run_to_end(const RunParts& parts, const SceneOnLattice& on_lattice, const RunOptions& options,
                      const std::optional<RunPast>& past) {
  auto& [program_start, communicator, system, trajectory, recorder, checkpoints, flow, progress] = parts;
  const long steps = total_steps(on_lattice, options);
  const long flow_interval = options.flow_every ? steps_between(on_lattice, *options.flow_every) : 0;
  const long checkpoint_interval =
      options.checkpoint_every ? steps_between(on_lattice, *options.checkpoint_every) : 0;
  const double start = MPI_Wtime();
  const auto cost = [&] { return MPI_Wtime() - start; };
  RunPast now = past.value_or(RunPast{});
  const auto keep = [&] {
    RunPast kept = now;
    kept.moment = system.moment();
    kept.wall_seconds += cost();
    kept.core_seconds += cost() * communicator.size();
    checkpoints.write(parts, kept);
  };
  RunOutcome outcome;
  outcome.last_totals = system.totals();
  if (!past) {
    now.first_totals = outcome.last_totals;
    recorder.sample(system);
    recorder.record(system, outcome.last_totals);
  }
  outcome.first_totals = now.first_totals;
  while (system.steps_done() < steps && outcome.status == RunStatus::finished) {
    system.step();
    recorder.sample(system);
    const long done = system.steps_done();
    const bool is_last = done == steps, is_frame = recorder.is_due(done);
    const bool is_flow = flow != nullptr && done % flow_interval == 0;
    bool is_checkpoint = checkpoint_interval > 0 && (is_last || done % checkpoint_interval == 0);
    const bool is_guard = is_last || is_checkpoint || done % steps_between_guards == 0;
    if (!is_guard && !is_frame && !is_flow) continue;

    SceneTotals totals = outcome.last_totals;
    const bool is_watched = is_last || is_frame || is_checkpoint || done % steps_between_totals == 0;
    if (is_watched) totals = system.totals();
    std::optional<Fault> fault = system.fault();
    if (!fault && is_watched) fault = loss_in(system, on_lattice, outcome.first_totals, totals);
    if (fault) {
      outcome.status = fault->kind == FaultKind::speed ? RunStatus::stopped_speed : RunStatus::failed;
      outcome.reason = describe(*fault, on_lattice, system.largest_bead_speed() * std::sqrt(3.0));
      break;
    }
    outcome.last_totals = totals;
    if (is_frame) recorder.record(system, totals);
    if (is_flow) flow->write(system);
    if (!is_guard) continue;
    if (communicator.is_root()) progress.update(done);
    if (const auto stop = is_last ? std::nullopt : asked_to_stop(program_start, options, communicator)) {
      outcome.status = stop->status;
      outcome.reason = fmt::format("step {} of {}: {}", done, steps, stop->reason);
      outcome.last_totals = system.totals();
      is_checkpoint = true;
    }
    if (is_checkpoint) keep();
  }
  outcome.wall_seconds = now.wall_seconds + cost();
  outcome.own_steps = system.steps_done() - now.moment.steps_done;
  outcome.core_seconds = now.core_seconds + cost() * communicator.size();
  if (communicator.is_root()) progress.finish(system.steps_done());
  return outcome;
}

}  // namespace beadswim
