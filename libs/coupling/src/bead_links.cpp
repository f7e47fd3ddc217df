#include "beadswim/coupling/bead_links.hpp"

#include <algorithm>
#include <numeric>

#include "beadswim/lattice/d3q19.hpp"

namespace beadswim {
namespace {

/// Rows at which a link that belongs to row (y, z) may have its other end: (y + dy, z + dz).
constexpr std::array<std::array<int, 2>, 5> facing_rows{{{0, 0}, {1, 0}, {-1, 1}, {0, 1}, {1, 1}}};

/// Row of the block, counted as the sweep goes, before which the links of row (y, z) of it or its halo must
/// be done.
int row_in_order(const Index3& block, int y, int z) {
  if (z < 0) return 0;
  return std::clamp(y, 0, block[1] - 1) + block[1] * std::min(z, block[2] - 1);
}

/// Appends the links from runs of covered cells.
struct LinkFinder {
  const Coverage& coverage;
  std::vector<BeadLink>& links;

  /// From the run in row (y, z) to row (y + cy, z + cz), in which the same image covers `facing`.
  void add(const CoveredRun& run, int y, int z, int cy, int cz, const CoveredRun& facing) {
    for (int cx = -1; cx <= 1; ++cx) {
      const int out = direction[cx + 1][cy + 1][cz + 1];
      if (out <= 0) continue;  // at rest, or no direction of the lattice
      add_cells(run.low, std::min(run.high, facing.low - cx), y, z, out);
      add_cells(std::max(run.low, facing.high - cx), run.high, y, z, out);
    }
  }

 private:
  static constexpr auto direction = [] {
    std::array<std::array<std::array<int, 3>, 3>, 3> table{};
    for (int x = 0; x < 3; ++x) {
      for (int y = 0; y < 3; ++y) {
        for (int z = 0; z < 3; ++z) table[x][y][z] = d3q19::direction_of(x - 1, y - 1, z - 1);
      }
    }
    return table;
  }();

  /// Covered cells [low, high) whose neighbours along `out` the same image does not cover.
  void add_cells(int low, int high, int y, int z, int out) {
    if (low >= high) return;
    const auto& c = d3q19::velocity[out];
    const int fy = y + c[1], fz = z + c[2], cells = coverage.block_size()[0];
    const bool row_is_own = coverage.is_own(0, y, z), fluid_row_is_own = coverage.is_own(0, fy, fz);
    if (!fluid_row_is_own && !(row_is_own && coverage.is_own_or_halo(0, fy, fz))) return;
    const std::ptrdiff_t fluid_row = coverage.cell(0, fy, fz);
    for (int x = low; x < high; ++x) {
      const int fx = x + c[0];
      const bool fluid_is_own = fluid_row_is_own && fx >= 0 && fx < cells;
      const bool is_own = row_is_own && x >= 0 && x < cells;
      if (!fluid_is_own && !is_own) continue;
      if (coverage.is_covered(fluid_row + fx)) continue;  // another bead's
      links.push_back(
          {.x = x, .y = y, .z = z, .out = static_cast<std::int8_t>(out), .fluid_is_own = fluid_is_own});
    }
  }
};

}  // namespace

void BeadLinks::find(const Coverage& coverage) {
  links_.clear();
  by_image_.clear();
  row_of_segment_.clear();
  boxes_.clear();
  const std::vector<CoveredImage>& images = coverage.images().images;
  for (int i = 0; i < std::ssize(images); ++i) {
    const BeadImage& box = images[i].image;
    boxes_.push_back({.low_y = box.low[1] - 1,
                      .low_z = box.low[2] - 1,
                      .rows_y = box.high[1] - box.low[1] + 2,
                      .first_segment = static_cast<int>(by_image_.size())});
    for (int z = box.low[2] - 1; z < box.high[2]; ++z) {
      for (int y = box.low[1] - 1; y <= box.high[1]; ++y) {
        const int first = static_cast<int>(links_.size());
        find_between_rows(coverage, images[i], y, z);
        by_image_.push_back({.first = first, .end = static_cast<int>(links_.size()), .image = i});
        row_of_segment_.push_back(row_in_order(coverage.block_size(), y, z));
      }
    }
  }
  sort_by_row(coverage.block_size());
}

/// Links of one image between row (y, z) and itself or later rows.
void BeadLinks::find_between_rows(const Coverage& coverage, const CoveredImage& covered, int y, int z) {
  LinkFinder finder{coverage, links_};
  const CoveredRun here = coverage.images().run(covered, y, z);
  for (const auto& [dy, dz] : facing_rows) {
    const CoveredRun there = coverage.images().run(covered, y + dy, z + dz);
    if (!here.empty()) finder.add(here, y, z, dy, dz, there);
    if (!there.empty() && (dy != 0 || dz != 0)) finder.add(there, y + dy, z + dz, -dy, -dz, here);
  }
}

/// Counting sort of the segments that have links.
void BeadLinks::sort_by_row(const Index3& block) {
  rows_y_ = block[1];
  first_of_row_.assign(block[1] * block[2] + 1, 0);
  for (std::size_t s = 0; s < by_image_.size(); ++s) {
    if (by_image_[s].first < by_image_[s].end) ++first_of_row_[row_of_segment_[s]];
  }
  std::exclusive_scan(first_of_row_.begin(), first_of_row_.end(), first_of_row_.begin(), 0);
  by_row_.resize(first_of_row_.back());
  std::vector<int>& next = next_of_row_;
  next = first_of_row_;
  for (std::size_t s = 0; s < by_image_.size(); ++s) {
    if (by_image_[s].first < by_image_[s].end) by_row_[next[row_of_segment_[s]]++] = by_image_[s];
  }
}

}  // namespace beadswim
