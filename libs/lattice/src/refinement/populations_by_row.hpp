#pragma once

#include <algorithm>
#include <vector>

#include "beadswim/core/vec3.hpp"
#include "beadswim/lattice/block.hpp"
#include "beadswim/lattice/populations.hpp"

namespace beadswim {

/// A population of a cell.
struct CellPopulation {
  Index3 cell = Index3::Zero();
  int direction = 0;
};

/// A list of populations of a block, row by row. Most rows contain the same populations, which are therefore
/// stored once: with a list for each row, most of the time would be spent on loading the lists.
class PopulationsByRow {
 public:
  /// Populations of one direction in successive cells along x.
  struct Run {
    int x = 0;  ///< local coordinate of the first cell
    int cells = 0;
    int direction = 0;

    bool operator==(const Run&) const = default;
  };

  PopulationsByRow() = default;
  /// `items`: populations of cells of the block in coordinates of the lattice, sorted by z and then by y.
  PopulationsByRow(const Block& block, std::vector<CellPopulation> items)
      : rows_in_plane_(block.size[1]), rows_(block.size[1] * block.size[2]), patterns_(1) {
    for (CellPopulation& item : items) item.cell -= block.offset;
    for (auto begin = items.begin(); begin != items.end();) {
      const auto end = std::find_if(begin, items.end(), [&](const CellPopulation& item) {
        return item.cell[1] != begin->cell[1] || item.cell[2] != begin->cell[2];
      });
      row(begin->cell[1], begin->cell[2]) = {.pattern = pattern_of(begin, end),
                                             .first = static_cast<int>(begin - items.begin())};
      begin = end;
    }
  }

  /// Calls visit(run, y, index of its first population in the list) for all runs of a plane of constant z.
  /// Visits equal runs of successive rows one after another, because their addresses are then foreseeable.
  template <class Visit>
  void for_each_run(int z, Visit&& visit) const {
    const Row* rows = rows_.data() + rows_in_plane_ * z;
    for (int y = 0, end = 0; y < rows_in_plane_; y = end) {
      while (end < rows_in_plane_ && rows[end].pattern == rows[y].pattern) ++end;
      int offset = 0;  // of the run in its row
      for (const Run& run : patterns_[rows[y].pattern]) {
        for (int at = y; at < end; ++at) visit(run, at, rows[at].first + offset);
        offset += run.cells;
      }
    }
  }
  int planes() const { return static_cast<int>(rows_.size()) / rows_in_plane_; }

 private:
  using Pattern = std::vector<Run>;
  struct Row {
    int pattern = 0;  ///< index in patterns_; the first one is empty
    int first = 0;    ///< index of the first population of the row in the list
  };

  Row& row(int y, int z) { return rows_[y + rows_in_plane_ * z]; }

  /// Returns the index of the pattern of a row.
  template <class Iterator>
  int pattern_of(Iterator begin, Iterator end) {
    Pattern pattern;
    for (; begin != end; ++begin) {
      const int x = begin->cell[0];
      if (!pattern.empty() && pattern.back().direction == begin->direction &&
          pattern.back().x + pattern.back().cells == x)
        ++pattern.back().cells;
      else
        pattern.push_back({.x = x, .cells = 1, .direction = begin->direction});
    }
    const auto found = std::ranges::find(patterns_, pattern);
    if (found != patterns_.end()) return static_cast<int>(found - patterns_.begin());
    patterns_.push_back(pattern);
    return static_cast<int>(patterns_.size()) - 1;
  }

  int rows_in_plane_ = 1;
  std::vector<Row> rows_;
  std::vector<Pattern> patterns_;
};

}  // namespace beadswim
