#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "beadswim/lattice/levels.hpp"
#include "number_exchange.hpp"

namespace beadswim {
namespace {

using Cell = std::array<double, d3q19::directions>;  ///< populations after collision

/// Populations of a box of cells.
class Region {
 public:
  explicit Region(const Block& block) : block_(block), cells_(block.size.cast<std::size_t>().prod()) {}

  Cell& operator[](const Index3& cell) { return cells_[index(cell)]; }
  const Cell& operator[](const Index3& cell) const { return cells_[index(cell)]; }

 private:
  std::size_t index(const Index3& cell) const {
    const Index3 p = cell - block_.offset;
    return p[0] + block_.size[0] * (p[1] + static_cast<std::size_t>(block_.size[1]) * p[2]);
  }

  Block block_;
  std::vector<Cell> cells_;
};

/// Returns the populations of a box of cells, which may be another box on each rank. Cells outside the level
/// are left at zero. Collective.
Region fetch(const Level& level, const Block& wanted, const Communicator& communicator) {
  const auto for_each_wanted =
      [&](auto&& visit) {  // calls visit(cell of `wanted`, its image in the level, owner)
        for_each_cell(wanted, [&](const Index3& at) {
          const Index3 cell = level.place.in_lattice(at);
          if (level.place.lattice.contains(cell)) visit(at, cell, level.decomposition.rank_of_cell(cell));
        });
      };
  std::vector<std::vector<Index3>> requests(communicator.size());
  for_each_wanted([&](const Index3&, const Index3& cell, int owner) { requests[owner].push_back(cell); });
  std::vector<std::vector<Cell>> answers;
  for (const std::vector<Index3>& cells : all_to_all(requests, communicator)) {
    std::vector<Cell>& answer = answers.emplace_back();
    for (const Index3& cell : cells) {
      const std::ptrdiff_t index = level.populations.cell(cell - level.block.offset);
      Cell& populations = answer.emplace_back();
      for (int i = 0; i < d3q19::directions; ++i) populations[i] = level.populations.outgoing(i, index);
    }
  }
  answers = all_to_all(answers, communicator);
  Region region(wanted);
  std::vector<std::size_t> next(answers.size(), 0);
  for_each_wanted(
      [&](const Index3& at, const Index3&, int owner) { region[at] = answers[owner][next[owner]++]; });
  return region;
}

/// Subtracts from `change` the equilibrium parts that would change mass and momentum of a cell.
void keep_moments(Cell& change) {
  double density, momentum[3];
  double populations[d3q19::directions];
  std::ranges::copy(change, populations);
  moments_of(populations, density, momentum);
  for (int i = 0; i < d3q19::directions; ++i) {
    const auto& c = d3q19::velocity[i];
    change[i] -=
        d3q19::weight(i) * (density + 3 * (c[0] * momentum[0] + c[1] * momentum[1] + c[2] * momentum[2]));
  }
}

/// Evaluates a coarser cell from the eight finer cells that begin at `first`.
Cell coarser_cell(const Region& finer, const Index3& first) {
  Cell mean{}, change{};
  for (int i = 0; i < d3q19::directions; ++i) {
    for (int part = 0; part < 8; ++part) {
      const Index3 side(part & 1, part >> 1 & 1, part >> 2);
      const double population = finer[first + side][i];
      mean[i] += population / 8;
      // The slope along an axis is the mean of the four on its high side minus the four on its low side.
      for (int a = 0; a < 3; ++a)
        change[i] += 0.5 * d3q19::velocity[i][a] * (side[a] == 1 ? population : -population) / 4;
    }
  }
  keep_moments(change);
  for (int i = 0; i < d3q19::directions; ++i) mean[i] += change[i];
  return mean;
}

/// Evaluates a finer cell from the coarser cell that contains it and the neighbours of the coarser cell.
Cell finer_cell(const Region& coarser, const Index3& cell) {
  const Index3 parent = cell.unaryExpr(&Block::floor_half);
  const Index3 side = 2 * (cell - 2 * parent) - 1;  // -1 or 1
  Cell result = coarser[parent], change{};
  for (int i = 0; i < d3q19::directions; ++i) {
    for (int a = 0; a < 3; ++a) {
      const double slope = (coarser[parent + unit_vector(a)][i] - coarser[parent - unit_vector(a)][i]) / 2;
      result[i] += side[a] * slope / 4;
      change[i] -= d3q19::velocity[i][a] * slope / 4;
    }
  }
  keep_moments(change);
  for (int i = 0; i < d3q19::directions; ++i) result[i] += change[i];
  return result;
}

void set_cell(Level& level, const Index3& cell, const Cell& populations) {
  const std::ptrdiff_t index = level.populations.cell(cell - level.block.offset);
  for (int i = 0; i < d3q19::directions; ++i) level.populations.set_outgoing(i, index, populations[i]);
}

/// Calls visit(slab) for slabs of planes z of a block, so that a slab with its neighbourhood needs little
/// memory. All ranks make the same number of calls; further slabs of a smaller block are empty. Collective.
template <class Visit>
void for_each_slab(const Block& block, const Communicator& communicator, Visit&& visit) {
  constexpr int planes = 16;
  int slabs = (block.size[2] + planes - 1) / planes;
  MPI_Allreduce(MPI_IN_PLACE, &slabs, 1, MPI_INT, MPI_MAX, communicator.get());
  for (int n = 0; n < slabs; ++n) {
    Block slab = block;
    slab.offset[2] += n * planes;
    slab.size[2] = std::clamp(block.size[2] - n * planes, 0, planes);
    visit(slab);
  }
}

/// Sets the cells of a level that lie under the next finer level. Collective.
void fill_refined_cells(Level& level, const Level& finer, const Communicator& communicator) {
  for_each_slab(level.block, communicator, [&](const Block& slab) {
    for (Block part : level.place.parts_under(finer.place, slab)) {
      part.offset += slab.offset;
      const Region cells = fetch(finer, part.doubled(), communicator);
      for_each_cell(part, [&](const Index3& cell) { set_cell(level, cell, coarser_cell(cells, 2 * cell)); });
    }
  });
}

}  // namespace

void transfer(Levels& from, Levels& to, const Communicator& communicator) {
  for (int n = from.count() - 2; n >= 0; --n) fill_refined_cells(from[n], from[n + 1], communicator);
  for (int n = 0; n < to.count(); ++n) {
    Level& level = to[n];
    const LevelPlace& before = from[n].place;
    for_each_slab(level.block, communicator, [&](const Block& slab) {
      const Region same = fetch(from[n], slab, communicator);
      std::optional<Region> coarser;
      if (n > 0)
        coarser = fetch(to[n - 1], slab.is_empty() ? Block{} : slab.halved().widened(), communicator);
      for_each_cell(slab, [&](const Index3& cell) {
        set_cell(level, cell, before.contains(cell) ? same[cell] : finer_cell(*coarser, cell));
      });
    });
  }
}

}  // namespace beadswim
