#include "beadswim/coupling/refinement.hpp"

#include <algorithm>
#include <cmath>

#include "beadswim/core/error.hpp"
#include "beadswim/coupling/swimmer_snapshot.hpp"
#include "beadswim/lattice/level_transfer.hpp"
#include "beadswim/lattice/nested_boxes.hpp"
#include "beadswim/swimmers/swimmer_shape.hpp"

namespace beadswim {
namespace {

/// Returns the distances between beads and interfaces. docs/refinement.md has the errors that they cause.
LevelMargins margins_of(const CoupledScene& scene) {
  constexpr double min_radii = 2;
  LevelMargins margins;
  for (const SwimmerType& type : scene.types) {
    for (const Bead& bead : type.beads)
      margins.around_region =
          std::max(margins.around_region, static_cast<int>(std::ceil(min_radii * bead.radius)));
  }
  return margins;
}

/// Returns the number of steps between two checks of the levels.
long steps_between_checks(int levels) {
  constexpr long min_steps = 16;
  return std::max(min_steps, 1L << (levels - 1));
}

/// Returns the smallest distance of a bead from the end of the finest level along axes that it does not span.
double gap_to_interface(const Level& finest, const BeadExtent& beads) {
  double gap = std::numeric_limits<double>::infinity();
  for (int a = 0; a < 3; ++a) {
    if (finest.place.spans(a)) continue;
    gap = std::min(
        {gap, beads.low[a] - finest.place.lattice.offset[a], finest.place.lattice.end()[a] - beads.high[a]});
  }
  return gap;
}

/// Returns the extent of the beads of all ranks, now and at the next check of the levels, if the beads keep
/// their velocities. Collective.
BeadExtent extent_until_next_check(const CoupledSystem& system, const Communicator& communicator) {
  const auto steps = static_cast<double>(steps_between_checks(system.levels().count()));
  BeadExtent beads;
  for (const SwimmerState& swimmer : system.owned_swimmers()) {
    for (std::size_t b = 0; b < swimmer.motion.size(); ++b) {
      const BeadMotion& bead = swimmer.motion[b];
      const double radius = system.scene().types[swimmer.type].beads[b].radius;
      beads.add(bead.position, radius);
      beads.add(bead.position + steps * bead.velocity, radius);
    }
  }
  MPI_Allreduce(MPI_IN_PLACE, beads.low.data(), 3, MPI_DOUBLE, MPI_MIN, communicator.get());
  MPI_Allreduce(MPI_IN_PLACE, beads.high.data(), 3, MPI_DOUBLE, MPI_MAX, communicator.get());
  return beads;
}

/// Returns the number of cells of a level.
double volume(const Block& level) {
  return level.size.cast<double>().prod();
}

/// Returns the sum of amount(n) over the levels n, per step of the finest level. `amount`: quantity per step
/// of level n.
template <class Amount>
double mean_per_step(const std::vector<Block>& levels, Amount&& amount) {
  double sum = 0;
  for (std::size_t n = 0; n < levels.size(); ++n)
    sum += std::ldexp(amount(n), static_cast<int>(n + 1) - static_cast<int>(levels.size()));
  return sum;
}

/// Returns the snapshots of all swimmers on every rank. Collective.
std::vector<SwimmerSnapshot> share_snapshots(CoupledSystem& system, const Communicator& communicator) {
  std::vector<char> bytes = bytes_of(system.gather_snapshots());
  broadcast(bytes, communicator);
  return snapshots_from_bytes(std::move(bytes));
}

}  // namespace

BeadExtent bead_extent(const CoupledScene& scene) {
  BeadExtent extent;
  const std::vector<Vec3> centres = start_positions(scene);
  const std::vector<double> radii = bead_radii(scene);
  for (std::size_t b = 0; b < centres.size(); ++b) extent.add(centres[b], radii[b]);
  return extent;
}

std::optional<std::vector<Block>> levels_around(const CoupledScene& scene, const BeadExtent& beads,
                                                int count) {
  return nested_levels(scene.cells, scene.boundary, beads.low, beads.high, count, margins_of(scene));
}

int max_levels(const CoupledScene& scene) {
  const BeadExtent beads = bead_extent(scene);
  int count = 1;
  while (count <= max_finer_levels && levels_around(scene, beads, count + 1)) ++count;
  return count;
}

double updates_per_step(const std::vector<Block>& levels) {
  return mean_per_step(levels, [&](std::size_t n) {
    const double refined = n + 1 < levels.size() ? volume(levels[n + 1]) / 8 : 0;
    return volume(levels[n]) - refined;
  });
}

double cost_per_step(const std::vector<Block>& levels) {
  constexpr double cost_of_outer_cell = 6;  // exchange; measured for levels of 64^3 cells
  const double exchange = mean_per_step(levels, [&](std::size_t n) {
    const double outer_cells = volume(levels[n]) - (levels[n].size - 2).cast<double>().prod();
    return n == 0 ? 0 : cost_of_outer_cell * outer_cells;
  });
  return updates_per_step(levels) + exchange;
}

double cells_on_levels(const std::vector<Block>& levels) {
  double cells = 0;
  for (const Block& level : levels) cells += volume(level);
  return cells;
}

std::vector<Block> cheapest_levels(const CoupledScene& scene, int max_count) {
  constexpr double max_share = 0.8;  // of the cost with one level
  const BeadExtent beads = bead_extent(scene);
  const double uniform = scene.cells.cast<double>().prod();
  std::vector<Block> cheapest;
  double min_cost = max_share * uniform;
  for (int count = 2; count <= max_count; ++count) {
    const auto levels = levels_around(scene, beads, count);
    if (!levels) break;
    if (cost_per_step(*levels) >= min_cost) continue;
    cheapest = *levels;
    min_cost = cost_per_step(cheapest);
  }
  return cheapest;
}

std::unique_ptr<CoupledSystem> with_levels_around_beads(CoupledSystem& system,
                                                        const Communicator& communicator) {
  const int count = system.levels().count();
  if (count == 1 || system.steps_done() % steps_between_checks(count) != 0) return nullptr;
  if (system.fault()) return nullptr;  // the run is about to stop, and the new system would not know why
  const CoupledScene& scene = system.scene();
  const BeadExtent beads = extent_until_next_check(system, communicator);
  const double margin = margins_of(scene).around_region;
  if (gap_to_interface(system.levels().finest(), beads) > margin / 2) return nullptr;
  const auto levels = levels_around(scene, beads, count);
  if (!levels || *levels == scene.levels) return nullptr;
  CoupledScene moved = scene;
  moved.levels = *levels;
  std::unique_ptr<CoupledSystem> next;
  try {
    next = std::make_unique<CoupledSystem>(moved, communicator);
  } catch (const InputError&) {  // on all ranks: they cannot share levels of this size
    return nullptr;
  }
  next->restore(system.progress(), share_snapshots(system, communicator),
                [&](Levels& fluid) { transfer(system.levels(), fluid, communicator); });
  return next;
}

}  // namespace beadswim
