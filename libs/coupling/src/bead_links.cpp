#include "beadswim/coupling/bead_links.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

#include "beadswim/lattice/d3q19.hpp"
#include "beadswim/lattice/fluid_step.hpp"

namespace beadswim {
namespace {

/// Rows at which a link that belongs to row (y, z) may have its other end: (y + dy, z + dz).
constexpr std::array<std::array<int, 2>, 5> facing_rows{{{0, 0}, {1, 0}, {-1, 1}, {0, 1}, {1, 1}}};

/// Row of the block, counted as the step goes, before which the links that belong to row (y, z) of it or its
/// halo must be done: the first of the rows that they join.
int row_in_order(const Index3& block, int y, int z) {
  int first = std::numeric_limits<int>::max();
  for (const auto& [dy, dz] : facing_rows) {
    if (z + dz < 0 || z + dz >= block[2]) continue;
    first =
        std::min(first, std::clamp(y + dy, 0, block[1] - 1) + block[1] * place_in_order(z + dz, block[2]));
  }
  return first;
}

/// Appends links from runs of covered cells of one image.
struct LinkFinder {
  const Coverage& coverage;
  const CoveredImage& covered;
  bool is_alone;
  std::vector<BeadLink>& links;

  /// Links between row (y, z) and itself or later rows.
  void add_between_rows(int y, int z) {
    const CoveredRun here = coverage.images().run(covered, y, z);
    for (const auto& [dy, dz] : facing_rows) {
      const CoveredRun there = coverage.images().run(covered, y + dy, z + dz);
      if (!here.empty()) add(here, y, z, dy, dz, there);
      if (!there.empty() && (dy != 0 || dz != 0)) add(there, y + dy, z + dz, -dy, -dz, here);
    }
  }

 private:
  /// From the run in row (y, z) to row (y + cy, z + cz), in which the same image covers `facing`.
  void add(const CoveredRun& run, int y, int z, int cy, int cz, const CoveredRun& facing) {
    for (int cx = -1; cx <= 1; ++cx) {
      const int out = direction[cx + 1][cy + 1][cz + 1];
      if (out <= 0) continue;  // at rest, or no direction of the lattice
      add_cells(run.low, std::min(run.high, facing.low - cx), y, z, out);
      add_cells(std::max(run.low, facing.high - cx), run.high, y, z, out);
    }
  }

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
    const Index3 from_low = Index3(0, y, z) - covered.image.low;
    for (int x = low; x < high; ++x) {
      const int fx = x + c[0];
      const bool fluid_is_own = fluid_row_is_own && fx >= 0 && fx < cells;
      const bool is_own = row_is_own && x >= 0 && x < cells;
      if (!fluid_is_own && !is_own) continue;
      if (!is_alone && coverage.is_covered(fluid_row + fx)) continue;  // another bead's
      links.push_back(
          {.from_low = {static_cast<std::int16_t>(x + from_low[0]), static_cast<std::int16_t>(from_low[1]),
                        static_cast<std::int16_t>(from_low[2])},
           .out = static_cast<std::int8_t>(out),
           .fluid_is_own = fluid_is_own});
    }
  }
};

bool same_box(const BeadImage& a, const BeadImage& b) {
  return (a.low == b.low).all() && (a.high == b.high).all();
}

/// Whether cells of one box may be neighbours of cells of the other.
bool may_meet(const BeadImage& a, const BeadImage& b) {
  return (a.low <= b.high).all() && (b.low <= a.high).all();
}

/// Of each image, whether no other one may have cells next to its own.
std::vector<bool> images_alone(const std::vector<CoveredImage>& images) {
  std::vector<int> by_z(images.size());
  std::iota(by_z.begin(), by_z.end(), 0);
  const auto low_z = [&](int i) { return images[i].image.low[2]; };
  std::ranges::sort(by_z, {}, low_z);
  std::vector<bool> alone(images.size(), true);
  for (auto a = by_z.begin(); a != by_z.end(); ++a) {
    for (auto b = a + 1; b != by_z.end() && low_z(*b) <= images[*a].image.high[2]; ++b) {
      if (may_meet(images[*a].image, images[*b].image)) alone[*a] = alone[*b] = false;
    }
  }
  return alone;
}

}  // namespace

void BeadLinks::find(const Coverage& coverage) {
  const std::vector<CoveredImage>& images = coverage.images().images;
  const std::vector<bool> alone = images_alone(images);
  images_.resize(images.size());
  for (std::size_t i = 0; i < images.size(); ++i) find_of_image(coverage, images[i], alone[i], images_[i]);
  sort_by_row(coverage.block_size());
}

void BeadLinks::find_of_image(const Coverage& coverage, const CoveredImage& covered, bool is_alone,
                              ImageLinks& known) {
  const std::span<const CoveredRun> runs = coverage.images().runs_of(covered);
  const bool keep = known.is_alone && is_alone && same_box(known.box, covered.image);
  if (keep && std::ranges::equal(known.runs, runs)) return;
  const auto changed = [&](int y, int z) {
    const int run = coverage.images().run_index(covered, y, z);
    return run >= 0 && known.runs[run] != runs[run];
  };

  found_.clear();
  first_found_.clear();
  LinkFinder finder{coverage, covered, is_alone, found_};
  const BeadImage& box = covered.image;
  for (int z = box.low[2] - 1; z < box.high[2]; ++z) {
    for (int y = box.low[1] - 1; y <= box.high[1]; ++y) {
      first_found_.push_back(static_cast<int>(found_.size()));
      const bool kept = keep && std::ranges::none_of(facing_rows, [&](const auto& row) {
                          return changed(y + row[0], z + row[1]);
                        });
      if (kept) {
        const int row = known.row(y, z);
        found_.insert(found_.end(), known.links.begin() + known.first_of_row[row],
                      known.links.begin() + known.first_of_row[row + 1]);
      } else {
        finder.add_between_rows(y, z);
      }
    }
  }
  first_found_.push_back(static_cast<int>(found_.size()));

  known.box = covered.image;
  known.is_alone = is_alone;
  known.runs.assign(runs.begin(), runs.end());
  known.first_of_row = first_found_;
  known.links.assign(found_.begin(), found_.end());
}

/// Counting sort of the segments that have links.
void BeadLinks::sort_by_row(const Index3& block) {
  block_ = block;
  const auto for_each_segment = [&](auto&& visit) {
    for (int i = 0; i < std::ssize(images_); ++i) {
      const ImageLinks& of = images_[i];
      for (int z = of.box.low[2] - 1; z < of.box.high[2]; ++z) {
        for (int y = of.box.low[1] - 1; y <= of.box.high[1]; ++y) {
          const int row = of.row(y, z);
          const LinkSegment segment{
              .first = of.first_of_row[row], .end = of.first_of_row[row + 1], .image = i};
          if (segment.first < segment.end) visit(row_in_order(block, y, z), segment);
        }
      }
    }
  };
  first_of_row_.assign(block[1] * block[2] + 1, 0);
  for_each_segment([&](int row, const LinkSegment&) { ++first_of_row_[row]; });
  std::exclusive_scan(first_of_row_.begin(), first_of_row_.end(), first_of_row_.begin(), 0);
  by_row_.resize(first_of_row_.back());
  next_of_row_ = first_of_row_;
  for_each_segment([&](int row, const LinkSegment& segment) { by_row_[next_of_row_[row]++] = segment; });
}

}  // namespace beadswim
