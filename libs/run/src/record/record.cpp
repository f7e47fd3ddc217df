#include "run_parts.hpp"

#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "beadswim/compare/cycle_statistics.hpp"
#include "beadswim/compare/run_uncertainty.hpp"

namespace beadswim {
namespace {

/// Returns the peak resident memory of each rank, summed over all ranks [byte]. Collective.
std::int64_t peak_memory_bytes(const Communicator& communicator) {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  std::int64_t bytes = std::int64_t{1024} * usage.ru_maxrss;
  MPI_Allreduce(MPI_IN_PLACE, &bytes, 1, MPI_INT64_T, MPI_SUM, communicator.get());
  return bytes;
}

/// Adds momentum and relative mass change to the record if the model evaluates them. `first`, `last`: totals
/// at the start and at the end of the run.
void add_conservation(RunRecord& record, const ModelTotals& first, const ModelTotals& last) {
  if (first.momentum && last.momentum)
    record.momentum = MomentumRecord{.total = *last.momentum, .initial = *first.momentum};
  if (first.mass_excess && last.mass_excess)
    record.mass_relative_change = (1 + *last.mass_excess) / (1 + *first.mass_excess) - 1;
}

SwimmerUncertainty uncertainty_of(const SwimmerRecord& swimmer, const std::optional<Box>& box,
                                  const std::optional<ExpectedErrors>& expected) {
  std::vector<double> velocities;
  const std::size_t arms = swimmer.cycles.front().arm_amplitudes.size();
  std::vector<std::vector<double>> amplitudes(arms);
  for (const CycleStatistics& cycle : swimmer.cycles) {
    velocities.push_back(velocity_relative_to_fluid(cycle, box));
    for (std::size_t arm = 0; arm < arms; ++arm) amplitudes[arm].push_back(cycle.arm_amplitudes[arm]);
  }
  // `values`: the quantity in successive cycles; `of`: its component of an ErrorEstimate.
  const auto uncertainty = [&](const std::vector<double>& values, const auto& of) {
    QuantityUncertainty result{.transient = remaining_change(values)};
    if (expected) {
      result.resolution = of(expected->resolution);
      result.wander = of(expected->wander);
      result.box = of(expected->box);
    }
    result.total = total_uncertainty(result);
    return result;
  };
  SwimmerUncertainty result;
  result.velocity = uncertainty(velocities, [](const ErrorEstimate& e) { return e.velocity; });
  for (std::size_t arm = 0; arm < arms; ++arm) {
    const QuantityUncertainty of_arm = uncertainty(
        amplitudes[arm], [arm](const ErrorEstimate& e) { return e.arm_amplitudes[arm < 2 ? arm : 1]; });
    if (arm == 0 || of_arm.total > result.arm_amplitudes.total) result.arm_amplitudes = of_arm;
  }
  return result;
}

/// Adds expected errors, uncertainties and warnings. Rank 0 only.
void add_errors(RunRecord& record, const ModelPlan& plan, const std::vector<RunWarning>& after) {
  if (plan.expected) record.expected_error = plan.expected->total;
  for (SwimmerRecord& swimmer : record.swimmers) {
    if (!swimmer.cycles.empty())
      swimmer.uncertainty = uncertainty_of(swimmer, record.domain.box, plan.expected);
  }
  record.warnings = plan.warnings;
  record.warnings->insert(record.warnings->end(), after.begin(), after.end());
}

}  // namespace

RunRecord make_record(const RunParts& parts, const LayoutDocument& document, const RunOutcome& outcome,
                      const std::vector<RunWarning>& late) {
  RunRecord record;
  record.status = outcome.status;
  record.reason = outcome.reason;
  set_surroundings(document.layout, parts.plan.base_period, record);
  if (parts.plan.swimmers.size() <= max_swimmers_listed) {
    record.swimmers = parts.recorder.swimmers();
    record.scene = document.layout;
  }
  if (!parts.recorder.swarm().empty() || record.swimmers.empty()) record.swarm = parts.recorder.swarm();
  add_conservation(record, parts.model.first_totals(), outcome.last_totals);
  record.cost = RunCost{.wall_seconds = outcome.history.wall_seconds,
                        .core_seconds = outcome.history.core_seconds,
                        .cycles = static_cast<double>(outcome.history.steps_done) /
                                  static_cast<double>(parts.plan.steps_per_cycle),
                        .ranks = parts.communicator.size(),
                        .cell_updates = std::nullopt,
                        .mlups = std::nullopt,
                        .peak_memory_bytes = peak_memory_bytes(parts.communicator),
                        .communication = std::nullopt};
  parts.model.describe(record);
  if (record.thermal) record.thermal->diffusion = parts.recorder.diffusion();
  add_errors(record, parts.plan, late);
  if (!document.study.is_null()) record.study = document.study;
  record.provenance = document.provenance;
  return record;
}

DimensionlessNumbers dimensionless_numbers(std::span<const SwimmerType> types, double speed,
                                           double kinematic_viscosity, double period) {
  const double largest = largest_radius(types), omega = 2 * std::numbers::pi / period;
  double smallest = largest;
  for (const SwimmerType& type : types) smallest = std::min(smallest, smallest_radius(type));
  return {.reynolds_bead = speed * 2 * largest / kinematic_viscosity,
          .penetration_depth_over_radius = std::sqrt(2 * kinematic_viscosity / omega) / smallest,
          .mach = std::nullopt};
}

}  // namespace beadswim
