#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "beadswim/core/communicator.hpp"
#include "beadswim/coupling/coupled_system.hpp"
#include "beadswim/coupling/lattice_settings.hpp"
#include "beadswim/coupling/scene.hpp"

// Levels of cells around the beads of a scene (levels.hpp).

namespace beadswim {

/// Returns the smallest box that contains all beads of a scene at their initial positions [cell].
Eigen::AlignedBox3d bead_extent(const CoupledScene& scene);

/// Chooses `count` nested levels around a box that contains the beads [cell]. Returns them coarsest first,
/// each in coordinates of its own cells; the first fills the box. Each level is the smallest box of whole
/// cells of the next coarser level that keeps distances to the beads and to the next finer level. Along a
/// periodic axis where it would come too close to its own image, it spans the box. Returns nothing if an edge
/// of the box is not a whole number of coarsest cells, or a level would come too close to a wall.
std::optional<std::vector<Block>> levels_around(const CoupledScene& scene, const Eigen::AlignedBox3d& beads,
                                                int count);

/// Returns the levels around the beads at their initial positions with which a step costs least. Returns
/// nothing if they would save less than a fifth of the cost of one level. `max_count`: largest number of
/// levels.
std::vector<Block> cheapest_levels(const CoupledScene& scene, int max_count = max_finer_levels + 1);

/// Returns the largest number of levels that fit into the box, at most max_finer_levels + 1.
int max_levels(const CoupledScene& scene);

/// Returns the number of cell updates in one step of the finest level, as a mean over steps. Cells under a
/// finer level are not updated.
double updates_per_step(const std::vector<Block>& levels);

/// Returns the cost of one step of the finest level, in units of the cost of a cell update:
/// updates_per_step() and the exchange between levels.
double cost_per_step(const std::vector<Block>& levels);

/// Returns the number of cells on all levels.
double cells_on_levels(const std::vector<Block>& levels);

/// Call this function after each step. If the levels are due to be checked, and a bead will come closer to
/// the end of the finest level, before the next check, than half the distance that levels_around() keeps,
/// returns a system in the same state with levels around the present positions of its beads. Returns nothing
/// in all other cases, also if the system has a fault or there is no room for other levels. The levels are
/// due after every max(16, 2^(levels - 1)) steps, when all of them have reached the same time. Collective.
std::unique_ptr<CoupledSystem> with_levels_around_beads(CoupledSystem& system,
                                                        const Communicator& communicator);

}  // namespace beadswim
