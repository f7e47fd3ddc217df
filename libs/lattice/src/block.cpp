#include "beadswim/lattice/block.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <limits>
#include <string>

#include "beadswim/core/error.hpp"
#include "beadswim/core/setting.hpp"

namespace beadswim {
namespace {

/// Returns the numbers of blocks along x, y and z (in total `ranks`) for which the halo exchange is cheapest.
/// Returns 0 in all components if there is no grid whose blocks are thick enough.
Index3 cheapest_grid(const SharedCells& shared, int ranks) {
  const Index3& cells = shared.cells;
  Index3 best = Index3::Zero();
  double min_cost = std::numeric_limits<double>::infinity();
  const Eigen::Array3d n = cells.cast<double>();
  for (int gx = 1; gx <= ranks; ++gx) {
    if (ranks % gx != 0) continue;
    for (int gy = 1; gy <= ranks / gx; ++gy) {
      if ((ranks / gx) % gy != 0) continue;
      const Index3 grid(gx, gy, ranks / gx / gy);
      if ((shared.thickness * grid > cells).any()) continue;
      // Cost of exchanging a halo cell across x, divided by the cost across y or z. It is larger because each
      // exchanged population lies in a separate cache line, and because the rows become shorter.
      constexpr double strided = 4;
      const double cost = strided * gx * n[1] * n[2] + grid[1] * n[0] * n[2] + grid[2] * n[0] * n[1];
      if (cost < min_cost) {
        min_cost = cost;
        best = grid;
      }
    }
  }
  return best;
}

}  // namespace

void require_grids(const std::vector<SharedCells>& lattices, int ranks) {
  const auto refused = [&](int n) {
    return std::ranges::find_if(
        lattices, [n](const SharedCells& shared) { return (cheapest_grid(shared, n) == 0).any(); });
  };
  const auto first = refused(ranks);
  if (first == lattices.end()) return;
  int fewer = ranks - 1;
  while (fewer > 0 && refused(fewer) != lattices.end()) --fewer;
  const Index3& cells = first->cells;
  std::string choice = first->thickness > 1 ? fmt::format("another {}", Setting::bead_boundary) : "";
  if (fewer > 0)
    choice = fmt::format("{} {}{}{}", Setting::ranks, fewer, choice.empty() ? "" : " or ", choice);
  throw InputError(Setting::ranks,
                   "{} ranks cannot share {} x {} x {} cells, because each block needs at least {} along "
                   "each axis; use {}",
                   ranks, cells[0], cells[1], cells[2], first->thickness, choice);
}

Decomposition::Decomposition(const Block& lattice, int ranks, int thickness) : lattice_(lattice) {
  const SharedCells shared{.cells = lattice.size, .thickness = thickness};
  require_grids({shared}, ranks);
  grid_ = cheapest_grid(shared, ranks);
}

Index3 Decomposition::grid_position(int rank) const {
  return {rank % grid_[0], rank / grid_[0] % grid_[1], rank / (grid_[0] * grid_[1])};
}

int Decomposition::rank_at(const Index3& p) const {
  return p[0] + grid_[0] * (p[1] + grid_[1] * p[2]);
}

Block Decomposition::block(int rank) const {
  const auto first_cell = [&](const Index3& position) -> Index3 {
    return (cells().cast<long>() * position.cast<long>() / grid_.cast<long>()).cast<int>();
  };
  const Index3 position = grid_position(rank), first = first_cell(position);
  return {.offset = lattice_.offset + first, .size = first_cell(position + 1) - first};
}

int Decomposition::rank_of_cell(const Index3& cell) const {
  // The last position in the grid whose first cell is not beyond `cell`.
  const Eigen::Array<long, 3, 1> end = (cell - lattice_.offset).cast<long>() + 1;
  return rank_at(((end * grid_.cast<long>() - 1) / cells().cast<long>()).cast<int>());
}

}  // namespace beadswim
