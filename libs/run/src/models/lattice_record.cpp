#include "models/lattice_model.hpp"

#include <algorithm>
#include <cmath>

#include "beadswim/coupling/refinement.hpp"
#include "beadswim/lattice/trt.hpp"
#include "run_parts.hpp"

namespace beadswim {
namespace {

CommunicationRecord communication_of(const CoupledSystem& system, const Traffic& sent, long steps,
                                     const Communicator& communicator) {
  std::array<std::int64_t, 3> maxima{system.neighbours(), sent.messages, sent.bytes};
  MPI_Allreduce(MPI_IN_PLACE, maxima.data(), maxima.size(), MPI_INT64_T, MPI_MAX, communicator.get());
  const double per_step = 1 / std::max(1.0, static_cast<double>(steps));
  return {.neighbours = static_cast<int>(maxima[0]),
          .messages_per_step = per_step * static_cast<double>(maxima[1]),
          .bytes_per_step = per_step * static_cast<double>(maxima[2])};
}

DimensionlessNumbers numbers_of(double largest_bead_speed, const SceneOnLattice& on_lattice) {
  DimensionlessNumbers numbers = dimensionless_numbers(
      on_lattice.scene.types, largest_bead_speed, lattice_viscosity(on_lattice.lattice.relaxation_time),
      static_cast<double>(on_lattice.lattice.steps_per_period));
  numbers.mach = largest_bead_speed * std::sqrt(3.0);
  return numbers;
}

/// Returns the levels of a scene. `cell`: edge of the finest cells [length].
std::vector<LevelRecord> levels_of(const CoupledScene& scene, double cell) {
  std::vector<LevelRecord> records;
  const std::vector<Block> levels = scene.all_levels();
  for (std::size_t n = 0; n < levels.size(); ++n) {
    const Block& level = levels[n];
    const double edge = std::ldexp(cell, static_cast<int>(levels.size() - 1 - n));
    records.push_back({.cell = edge,
                       .boxes = {{.lower = edge * level.offset.cast<double>().matrix(),
                                  .upper = edge * level.end().cast<double>().matrix()}},
                       .cells = level.size.cast<std::int64_t>().prod()});
  }
  return records;
}

/// `scene` is the scene with its present levels.
LatticeResolution resolution_of(const SceneOnLattice& on_lattice, const CoupledScene& scene) {
  const UnitScales& scales = on_lattice.lattice.scales;
  return {.cells_per_radius = on_lattice.resolution.cells_per_radius,
          .cell_size = scales.length,
          .time_step = scales.time,
          .relaxation_time = on_lattice.lattice.relaxation_time,
          .kinematic_viscosity_lattice = lattice_viscosity(on_lattice.lattice.relaxation_time),
          .steps_per_cycle = on_lattice.lattice.steps_per_period,
          .bead_boundary = to_text(on_lattice.scene.bead_boundary),
          .density_on_lattice = on_lattice.density_on_lattice(),
          .radius_on_lattice = on_lattice.radius_on_lattice(),
          .angular_softening = on_lattice.angular_softening(),
          .precision = to_text(on_lattice.scene.precision),
          .levels = levels_of(scene, scales.length)};
}

NearContactRecord near_contact_of(const CoupledSystem& system, const SceneOnLattice& on_lattice) {
  const NearContactLaw law = near_contact_law(on_lattice.scene);
  const double cell = on_lattice.lattice.scales.length, gap = system.smallest_gap();
  return {.smallest_gap = std::isfinite(gap) ? std::optional(gap * cell) : std::nullopt,
          .lubrication = on_lattice.scene.lubrication,
          .normal_cut_off = law.range.normal * cell,
          .tangential_cut_off = law.range.tangential * cell,
          .friction = law.friction};
}

}  // namespace

void describe_lattice_run(RunRecord& record, const CoupledSystem& system, const SceneOnLattice& on_lattice,
                          const Traffic& traffic, long own_steps, const Communicator& communicator) {
  record.model = to_text(RunModel::lbm);
  record.dimensionless = numbers_of(system.largest_bead_speed(), on_lattice);
  record.resolution = resolution_of(on_lattice, system.scene());
  RunCost& cost = *record.cost;
  cost.cell_updates =
      std::llround(updates_per_step(system.scene().all_levels()) * static_cast<double>(system.steps_done()));
  cost.mlups = 1e-6 * static_cast<double>(*cost.cell_updates) / cost.wall_seconds;
  cost.communication = communication_of(system, traffic, own_steps, communicator);
  record.near_contact = near_contact_of(system, on_lattice);
  // After a fault the beads do not move any more, so the hash of the last state would be meaningless.
  if (record.status != RunStatus::failed && record.status != RunStatus::stopped_speed)
    record.state_sha256 = state_sha256(system, communicator);
}

}  // namespace beadswim
