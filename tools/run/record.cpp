#include "record.hpp"

#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "beadswim/coupling/gather.hpp"
#include "beadswim/lattice/trt.hpp"

namespace beadswim {
namespace {

/// Largest resident memory of all ranks together.
std::int64_t peak_memory_bytes(const Communicator& communicator) {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  std::int64_t bytes = std::int64_t{1024} * usage.ru_maxrss;
  MPI_Allreduce(MPI_IN_PLACE, &bytes, 1, MPI_INT64_T, MPI_SUM, communicator.get());
  return bytes;
}

CommunicationRecord communication_of(const RunParts& parts, long steps) {
  const Traffic sent = parts.system.traffic();
  std::array<std::int64_t, 3> most{parts.system.neighbours(), sent.messages, sent.bytes};
  MPI_Allreduce(MPI_IN_PLACE, most.data(), most.size(), MPI_INT64_T, MPI_MAX, parts.communicator.get());
  const double each = 1 / std::max(1.0, static_cast<double>(steps));
  return {.neighbours = static_cast<int>(most[0]),
          .messages_per_step = each * static_cast<double>(most[1]),
          .bytes_per_step = each * static_cast<double>(most[2])};
}

RunCost cost_of(const RunParts& parts, const SceneOnLattice& on_lattice, const RunOutcome& outcome) {
  const std::int64_t updates = on_lattice.scene.cells.cast<std::int64_t>().prod() *
                               static_cast<std::int64_t>(parts.system.steps_done());
  const int ranks = parts.communicator.size();
  return {.wall_seconds = outcome.wall_seconds,
          .core_seconds = outcome.core_seconds,
          .ranks = ranks,
          .cell_updates = updates,
          .mlups = 1e-6 * static_cast<double>(updates) / outcome.wall_seconds,
          .peak_memory_bytes = peak_memory_bytes(parts.communicator),
          .communication = communication_of(parts, outcome.own_steps)};
}

DimensionlessNumbers numbers_of(double largest_bead_speed, const SceneOnLattice& on_lattice) {
  double smallest = on_lattice.scene.types.front().beads[0].radius, largest = smallest;
  for (const SwimmerType& type : on_lattice.scene.types) {
    for (const Bead& bead : type.beads) {
      smallest = std::min(smallest, bead.radius);
      largest = std::max(largest, bead.radius);
    }
  }
  const double nu = lattice_viscosity(on_lattice.lattice.relaxation_time);
  const double omega = 2 * std::numbers::pi / static_cast<double>(on_lattice.lattice.steps_per_period);
  return {.reynolds_bead = largest_bead_speed * 2 * largest / nu,
          .penetration_depth_over_radius = std::sqrt(2 * nu / omega) / smallest,
          .mach = largest_bead_speed * std::sqrt(3.0)};
}

/// None if the swimmers' driving differs.
std::optional<DrivingRecord> shared_driving(const Layout& layout) {
  const Driving first = layout.resolved_type(layout.swimmers.front()).driving;
  for (const Swimmer& swimmer : layout.swimmers) {
    const Driving other = layout.resolved_type(swimmer).driving;
    if (other.amplitude != first.amplitude || other.phase != first.phase) return std::nullopt;
  }
  return DrivingRecord{first.amplitude, first.phase};
}

NearContactRecord near_contact_of(const CoupledSystem& system, const SceneOnLattice& on_lattice) {
  const NearContactLaw law = near_contact_law(on_lattice.scene);
  const double cell = on_lattice.lattice.scales.cell, gap = system.smallest_gap();
  return {.smallest_gap = std::isfinite(gap) ? std::optional(gap * cell) : std::nullopt,
          .lubrication = on_lattice.scene.lubrication,
          .normal_cut_off = law.range.normal * cell,
          .tangential_cut_off = law.range.tangential * cell,
          .friction = law.friction};
}

}  // namespace

RunRecord make_record(const RunParts& parts, const SceneOnLattice& on_lattice, const LayoutDocument& document,
                      const RunOutcome& outcome, const RunOptions& options) {
  const SceneTotals &first = outcome.first_totals, &last = outcome.last_totals;
  const LatticeScales& scales = on_lattice.lattice.scales;
  RunRecord record;
  record.model = "lbm";
  record.status = outcome.status;
  record.reason = outcome.reason;
  record.units = document.layout.units;
  record.domain = document.layout.domain;
  record.driving_period = on_lattice.period;
  record.driving = shared_driving(document.layout);
  if (on_lattice.scene.swimmers.size() <= most_swimmers_listed) record.swimmers = parts.recorder.swimmers();
  record.swarm = parts.recorder.swarm();
  record.momentum = MomentumRecord{.total = last.momentum * scales.momentum(),
                                   .initial = first.momentum * scales.momentum()};
  record.mass_relative_change = (1 + last.mass_excess) / (1 + first.mass_excess) - 1;
  record.dimensionless = numbers_of(parts.system.largest_bead_speed(), on_lattice);
  record.resolution =
      LatticeResolution{.cells_per_radius = on_lattice.cells_per_radius,
                        .cell_size = scales.cell,
                        .time_step = scales.step,
                        .relaxation_time = on_lattice.lattice.relaxation_time,
                        .kinematic_viscosity_lattice = lattice_viscosity(on_lattice.lattice.relaxation_time),
                        .steps_per_cycle = on_lattice.lattice.steps_per_period,
                        .bead_boundary = name_of(on_lattice.scene.bead_boundary),
                        .density_on_lattice = on_lattice.density_on_lattice(),
                        .radius_on_lattice = on_lattice.radius_on_lattice(),
                        .angular_softening = on_lattice.angular_softening,
                        .precision = name_of(on_lattice.scene.precision)};
  record.cost = cost_of(parts, on_lattice, outcome);
  record.near_contact = near_contact_of(parts.system, on_lattice);
  // After a fault swimmers waited where they were: the last state is no result.
  if (outcome.status != RunStatus::failed && outcome.status != RunStatus::stopped_speed)
    record.state_sha256 = state_sha256(parts.system, parts.communicator);
  record.provenance = document.provenance;
  record.provenance->push_back(options.provenance);
  return record;
}

}  // namespace beadswim
