#include "run_loop.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "beadswim/core/error.hpp"
#include "stop_signal.hpp"

namespace beadswim {
namespace {

/// Steps between looks at what may stop the run: ranks agree there, and only there.
constexpr long steps_between_guards = 20;

std::string describe(const SpeedFault& fault, const LatticeScales& scales) {
  const Vec3 p = fault.position * scales.cell;
  return fmt::format(
      "step {}: bead {} of swimmer {} at ({:.6g}, {:.6g}, {:.6g}) moves {:.3g} cells a step (Mach "
      "{:.2g}), over the limit of 0.5; drive it less, or take a smaller step by --relaxation-time",
      fault.step, fault.bead.bead + 1, fault.bead.swimmer, p[0], p[1], p[2], fault.speed,
      fault.speed * std::sqrt(3.0));
}

/// Why the run should stop here although nothing is wrong: a signal to any rank, or the time limit by rank
/// 0's clock. The same answer on all ranks.
std::optional<RunOutcome> asked_to_stop(double start, const RunOptions& options,
                                        const Communicator& communicator) {
  const double seconds = MPI_Wtime() - start;
  std::array<int, 2> asked{stop_signal(),
                           communicator.is_root() && seconds > options.time_limit.value_or(seconds)};
  MPI_Allreduce(MPI_IN_PLACE, asked.data(), asked.size(), MPI_INT, MPI_MAX, communicator.get());
  if (asked[0] != 0)
    return RunOutcome{RunStatus::stopped_signal, fmt::format("stopped by signal {}", asked[0]), 0};
  if (asked[1] == 0) return std::nullopt;
  return RunOutcome{
      RunStatus::stopped_time,
      fmt::format("the time limit of {} s is over; a longer --time-limit, or more ranks, take the run to "
                  "its end",
                  *options.time_limit),
      0};
}

long steps_between_flows(const SceneOnLattice& on_lattice, double cycles) {
  return std::max(1L, std::lround(cycles * static_cast<double>(on_lattice.lattice.steps_per_period)));
}

void take_step(CoupledSystem& system, Recorder& recorder) {
  try {
    system.step();
    recorder.record(system);
  } catch (const NotFiniteError& error) {
    throw SolverError(
        fmt::format("step {}: the fluid has become unstable ({}); take a smaller step by "
                    "--relaxation-time, more cells a radius, or weaker driving",
                    system.steps_done(), error.what()));
  } catch (const SolverError& error) {
    throw SolverError(fmt::format("step {}: {}", system.steps_done(), error.what()));
  }
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

RunOutcome run_to_end(const RunParts& parts, const SceneOnLattice& on_lattice, const RunOptions& options) {
  auto& [communicator, system, recorder, flow, progress] = parts;
  const long steps = total_steps(on_lattice, options);
  const long flow_interval = options.flow_every ? steps_between_flows(on_lattice, *options.flow_every) : 0;
  const double start = MPI_Wtime();
  RunOutcome outcome;
  recorder.record(system);
  while (system.steps_done() < steps && outcome.status == RunStatus::finished) {
    take_step(system, recorder);
    const long done = system.steps_done();
    if (flow != nullptr && done % flow_interval == 0) flow->write(system);
    if (done % steps_between_guards != 0 && done != steps) continue;
    if (communicator.is_root()) progress.update(done);
    if (const auto fault = system.speed_fault()) {
      outcome = {RunStatus::stopped_speed, describe(*fault, on_lattice.lattice.scales), 0};
    } else if (const auto stop = asked_to_stop(start, options, communicator)) {
      outcome = *stop;
      outcome.reason = fmt::format("step {} of {}: {}", done, steps, stop->reason);
    }
  }
  outcome.wall_seconds = MPI_Wtime() - start;
  if (communicator.is_root()) progress.finish(system.steps_done());
  return outcome;
}

}  // namespace beadswim
