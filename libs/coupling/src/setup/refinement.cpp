#include "beadswim/coupling/refinement.hpp"

#include <algorithm>
#include <cmath>

#include "beadswim/core/error.hpp"
#include "beadswim/lattice/levels.hpp"
#include "beadswim/swimmers/swimmer_shape.hpp"

namespace beadswim {
namespace {

constexpr int cells_around_level = 4;  ///< cells of each level around the next finer level, at least

/// Returns the smallest permitted distance of the beads from the end of the finest level [finest cell].
/// docs/refinement.md has the errors that it causes.
int distance_to_interface(const CoupledScene& scene) {
  constexpr double min_radii = 2;
  return std::max(8, static_cast<int>(std::ceil(min_radii * largest_radius(scene.types))));
}

/// Places a level along one axis so that it contains [low, high], with cells_around_level coarser cells to
/// its own image. `cells`: cells of the box of this size. Returns false if a wall is in the way.
bool place_along(int axis, const Index3& cells, Boundary boundary, double low, double high, Block& level) {
  constexpr int room = 2 * cells_around_level;
  level.offset[axis] = 2 * static_cast<int>(std::floor(low / 2));
  level.size[axis] = 2 * static_cast<int>(std::ceil(high / 2)) - level.offset[axis];
  if (boundary == Boundary::periodic) {
    if (level.size[axis] + room <= cells[axis]) return true;
    level.offset[axis] = 0;
    level.size[axis] = cells[axis];
    return true;
  }
  return level.offset[axis] >= room && level.offset[axis] + level.size[axis] + room <= cells[axis];
}

long steps_between_checks(int levels) {
  constexpr long min_steps = 16;
  return std::max(min_steps, 1L << (levels - 1));
}

/// Returns the smallest distance of a bead from the end of the finest level along axes that it does not span.
double gap_to_interface(const Level& finest, const Eigen::AlignedBox3d& beads) {
  double gap = std::numeric_limits<double>::infinity();
  for (int a = 0; a < 3; ++a) {
    if (finest.place.spans(a)) continue;
    gap = std::min({gap, beads.min()[a] - finest.place.lattice.offset[a],
                    finest.place.lattice.end()[a] - beads.max()[a]});
  }
  return gap;
}

/// Extends the box so that it contains a bead.
void extend(Eigen::AlignedBox3d& box, const Vec3& centre, double radius) {
  box.extend(Vec3(centre.array() - radius)).extend(Vec3(centre.array() + radius));
}

/// Returns the extent of the beads of all ranks, now and at the next check of the levels, if the beads keep
/// their velocities. Collective.
Eigen::AlignedBox3d extent_until_next_check(const CoupledSystem& system, const Communicator& communicator) {
  const auto steps = static_cast<double>(steps_between_checks(system.levels().count()));
  Eigen::AlignedBox3d beads;
  for (const SwimmerState& swimmer : system.owned_swimmers()) {
    for (std::size_t b = 0; b < swimmer.motion.size(); ++b) {
      const BeadMotion& bead = swimmer.motion[b];
      const double radius = system.scene().types[swimmer.type].beads[b].radius;
      extend(beads, bead.position, radius);
      extend(beads, bead.position + steps * bead.velocity, radius);
    }
  }
  MPI_Allreduce(MPI_IN_PLACE, beads.min().data(), 3, MPI_DOUBLE, MPI_MIN, communicator.get());
  MPI_Allreduce(MPI_IN_PLACE, beads.max().data(), 3, MPI_DOUBLE, MPI_MAX, communicator.get());
  return beads;
}

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

}  // namespace

Eigen::AlignedBox3d bead_extent(const CoupledScene& scene) {
  Eigen::AlignedBox3d extent;
  const std::vector<Vec3> centres = start_positions(scene);
  const std::vector<double> radii = bead_radii(scene);
  for (std::size_t b = 0; b < centres.size(); ++b) extend(extent, centres[b], radii[b]);
  return extent;
}

std::optional<std::vector<Block>> levels_around(const CoupledScene& scene, const Eigen::AlignedBox3d& beads,
                                                int count) {
  const int distance = distance_to_interface(scene);
  std::vector<Block> levels(count);
  Index3 box = scene.cells;
  Vec3 low = beads.min().array() - distance, high = beads.max().array() + distance;
  for (int n = count - 1; n > 0; --n) {
    if ((box / 2 * 2 != box).any()) return std::nullopt;
    for (int a = 0; a < 3; ++a)
      if (!place_along(a, box, scene.boundary[a], low[a], high[a], levels[n])) return std::nullopt;
    low = levels[n].offset.cast<double>() / 2 - cells_around_level;
    high = levels[n].end().cast<double>() / 2 + cells_around_level;
    box /= 2;
  }
  levels[0] = {.offset = Index3::Zero(), .size = box};
  return levels;
}

int max_levels(const CoupledScene& scene) {
  const Eigen::AlignedBox3d beads = bead_extent(scene);
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
  const Eigen::AlignedBox3d beads = bead_extent(scene);
  std::vector<Block> cheapest;
  double min_cost = max_share * scene.cells.cast<double>().prod();
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
  const Eigen::AlignedBox3d beads = extent_until_next_check(system, communicator);
  const double distance = distance_to_interface(scene);
  if (gap_to_interface(system.levels().finest(), beads) > distance / 2) return nullptr;
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
  std::vector<char> swimmers = bytes_of(system.gather_snapshots());
  broadcast(swimmers, communicator);
  next->restore(system.progress(), values_from_bytes<SwimmerSnapshot>(std::move(swimmers)),
                [&](Levels& fluid) { transfer(system.levels(), fluid, communicator); });
  return next;
}

}  // namespace beadswim
