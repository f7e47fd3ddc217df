#include "beadswim/study/rank_groups.hpp"

#include <algorithm>
#include <numeric>

#include "beadswim/core/reason_against.hpp"
#include "beadswim/coupling/lattice_memory.hpp"
#include "beadswim/coupling/refinement.hpp"
#include "beadswim/coupling/scene_on_lattice.hpp"
#include "beadswim/documents/layout_document.hpp"
#include "beadswim/run/run_length.hpp"

namespace beadswim {
namespace {

/// Returns the number of ranks of a group for this number of layouts.
int smallest_group(std::size_t layouts, const Communicator& communicator) {
  return std::max(1, communicator.size() / std::max(1, static_cast<int>(layouts)));
}

/// Memory [byte] and work [updates of cells] of a run on the lattice, and the number of its cells if all
/// ranks can share them, else 0.
struct LatticeSize {
  double bytes = 0, updates = 0, shared_cells = 0;
};

/// Returns true if each rank gets a block of at least two cells along each axis, which all schemes of beads
/// can treat.
bool can_share(const std::vector<Block>& levels, int ranks) {
  const std::string reason = reason_against([&] {
    for (const Block& level : levels) Decomposition(level, ranks, min_thickness(HaloContent::behind));
  });
  return reason.empty();
}

/// Returns 0 for a layout that the lattice refuses. `ranks`: number of all ranks.
LatticeSize lattice_size(const StreamMember& member, const RunSettings& settings, int ranks) {
  LatticeSize size;
  reason_against([&] {
    const SceneOnLattice on_lattice =
        put_on_lattice(layout_of(member).layout, settings.lattice, member.source);
    const long steps = total_steps(settings.cycles, on_lattice.lattice.steps_per_period);
    const std::vector<Block> levels = on_lattice.scene.all_levels();
    size = {.bytes = lattice_bytes(on_lattice.scene),
            .updates = updates_per_step(levels) * static_cast<double>(steps),
            .shared_cells = can_share(levels, ranks) ? cells_on_levels(levels) : 0};
  });
  return size;
}

/// Moves the large lattices from `side_by_side` to `on_all_ranks`. `bytes_of_rank`: memory that each rank may
/// use.
void move_large(StreamSchedule& schedule, const std::vector<LatticeSize>& sizes, double bytes_of_rank,
                const Communicator& communicator) {
  constexpr double min_cells_of_rank = 32 * 32 * 32;  // with fewer, messages take much of the time
  constexpr double max_share = 1.25;                  // of a small lattice, in the mean work of a group
  const double work = std::transform_reduce(sizes.begin(), sizes.end(), 0.0, std::plus(),
                                            [](const LatticeSize& size) { return size.updates; });
  const auto is_small = [&](int number) {
    const LatticeSize& size = sizes[number - 1];
    return size.shared_cells < min_cells_of_rank * communicator.size() ||
           (size.bytes <= bytes_of_rank * schedule.ranks_per_run &&
            size.updates <= max_share * work / schedule.groups(communicator));
  };
  std::vector<int>& numbers = schedule.side_by_side;
  const auto first_large = std::stable_partition(numbers.begin(), numbers.end(), is_small);
  schedule.on_all_ranks.assign(first_large, numbers.end());
  numbers.erase(first_large, numbers.end());
}

}  // namespace

StreamSchedule schedule_of(const StoredStream& layouts, const RunSettings& settings,
                           const std::optional<int>& ranks_per_run, const Communicator& communicator) {
  StreamSchedule schedule;
  schedule.side_by_side.resize(layouts.size());
  std::iota(schedule.side_by_side.begin(), schedule.side_by_side.end(), 1);
  schedule.ranks_per_run = ranks_per_run.value_or(smallest_group(layouts.size(), communicator));
  if (ranks_per_run || settings.model != RunModel::lbm || schedule.groups(communicator) == 1) return schedule;
  double bytes_of_rank = installed_bytes() / count_ranks_on_node(communicator);
  MPI_Allreduce(MPI_IN_PLACE, &bytes_of_rank, 1, MPI_DOUBLE, MPI_MIN, communicator.get());
  std::vector<LatticeSize> sizes(layouts.size());
  for (int number = 1 + communicator.rank(); number <= layouts.size(); number += communicator.size())
    sizes[number - 1] = lattice_size(layouts.member(number), settings, communicator.size());
  MPI_Allreduce(MPI_IN_PLACE, sizes.data(), 3 * layouts.size(), MPI_DOUBLE, MPI_SUM, communicator.get());
  move_large(schedule, sizes, bytes_of_rank, communicator);
  schedule.ranks_per_run = smallest_group(schedule.side_by_side.size(), communicator);
  return schedule;
}

std::unique_ptr<Communicator> group_of(const StreamSchedule& schedule, const Communicator& communicator) {
  MPI_Comm own = MPI_COMM_NULL;
  MPI_Comm_split(communicator.get(), schedule.own_group(communicator), communicator.rank(), &own);
  auto group = std::make_unique<Communicator>(own);
  MPI_Comm_free(&own);
  return group;
}

}  // namespace beadswim
