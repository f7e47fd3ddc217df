#include "beadswim/coupling/coverage.hpp"

#include <algorithm>
#include <utility>

#include "beadswim/core/cell_list.hpp"

namespace beadswim {
namespace {

/// Returns r^2 - R^2, where r is the distance of a cell from the centre of the bead and R the radius of the
/// bead. The result is negative inside the bead.
double power(const CoveredImage& covered, int x, int y, int z) {
  return covered.from_centre(x, y, z).squaredNorm() - covered.radius * covered.radius;
}

/// Returns the cells of row (y, z) whose centres lie inside the bead. They are consecutive, because a sphere
/// is convex.
CoveredRun covered_run(const CoveredImage& covered, int y, int z) {
  const auto is_inside = [&](int x) { return power(covered, x, y, z) < 0; };
  CoveredRun run{.low = covered.image.low[0], .high = covered.image.high[0]};
  while (run.low < run.high && !is_inside(run.low)) ++run.low;
  while (run.low < run.high && !is_inside(run.high - 1)) --run.high;
  return run;
}

std::vector<ImagePair> find_close_pairs(const std::vector<CoveredImage>& images) {
  constexpr int distance = CoveredImages::close;
  std::vector<Vec3> centres;  // in local coordinates of the block
  double radius = 0;
  for (const CoveredImage& covered : images) {
    centres.push_back(covered.centre - covered.image.shift.cast<double>().matrix());
    radius = std::max(radius, covered.radius);
  }
  std::vector<ImagePair> pairs;
  visit_close_pairs(centres, 2 * radius + distance + 1, std::nullopt, [&](int a, int b, const Vec3&) {
    if (are_close(images[a].image, images[b].image, distance))
      pairs.push_back({std::min(a, b), std::max(a, b)});
    return true;
  });
  // The order of the cells differs between blocks, and three beads that overlap are divided in order.
  std::ranges::sort(pairs, {}, [](const ImagePair& pair) { return std::pair(pair.first, pair.second); });
  return pairs;
}

/// Divides the cells of row (y, z) that lie inside both beads between the runs of the two beads. A plane
/// separates the cells of the two beads, so that each run remains consecutive.
void part_row(const CoveredImage& first, CoveredRun& of_first, const CoveredImage& second,
              CoveredRun& of_second, int y, int z) {
  const auto is_lost = [&](int x) {
    const double inside_second = power(second, x, y, z);
    return inside_second < 0 && inside_second < power(first, x, y, z);
  };
  while (of_first.low < of_first.high && is_lost(of_first.low)) ++of_first.low;
  while (of_first.low < of_first.high && is_lost(of_first.high - 1)) --of_first.high;
  if (of_first.empty() || of_second.empty()) return;
  if (of_second.high <= of_first.low || of_first.high <= of_second.low) return;
  // Removes the cells of the first run from the second run. A second comparison of distances could assign a
  // cell to both beads because of rounding.
  if (of_first.low - of_second.low > of_second.high - of_first.high) {
    of_second.high = std::max(of_first.low, of_second.low);
  } else {
    of_second.low = std::min(of_first.high, of_second.high);
  }
}

}  // namespace

Coverage::Coverage(const BlockInLattice& lattice_block, const Populations& populations)
    : block_in_lattice_(lattice_block),
      pitch_y_(populations.pitch(1)),
      pitch_z_(populations.pitch(2)),
      origin_(populations.cell(0, 0, 0)),
      state_((lattice_block.block.size + 2 * margin).cast<std::ptrdiff_t>().prod(), State::fluid) {}

bool Coverage::is_fluid(const Index3& cell) const {
  Index3 inside = cell;
  for (int axis = 0; axis < 3; ++axis) {
    if (block_in_lattice_.is_periodic(axis)) continue;
    const int place = cell[axis] + block_in_lattice_.block.offset[axis], end = block_in_lattice_.cells[axis];
    if (place >= 0 && place < end) continue;
    if (block_in_lattice_.boundary[axis] == Boundary::no_slip) return false;
    inside[axis] = (place < 0 ? -1 - place : 2 * end - 1 - place) - block_in_lattice_.block.offset[axis];
  }
  return !is_covered(inside[0], inside[1], inside[2]);
}

bool Coverage::is_near_wall(const BeadImage& image, int distance) const {
  for (int axis = 0; axis < 3; ++axis) {
    const int low = image.low[axis] + block_in_lattice_.block.offset[axis],
              high = image.high[axis] + block_in_lattice_.block.offset[axis];
    if (!block_in_lattice_.is_periodic(axis) &&
        (low < distance || high > block_in_lattice_.cells[axis] - distance))
      return true;
  }
  return false;
}

void Coverage::update(std::span<const BeadOnLattice> beads) {
  std::swap(before_, now_);
  before_.for_each_run([&](const CoveredImage&, const CoveredRun& run, int y, int z) {
    const auto first = state_.begin() + place_of_state(run.low, y, z);
    std::fill_n(first, run.high - run.low, State::just_left);
  });
  newly_covered_.clear();
  find_runs(beads);
  now_.for_each_run([&](const CoveredImage& covered, const CoveredRun& run, int y, int z) {
    cover_run(covered, run, y, z);
  });
  uncovered_.clear();
  before_.for_each_run([&](const CoveredImage& covered, const CoveredRun& run, int y, int z) {
    for (int x = run.low; x < run.high; ++x) {
      State& now = state(x, y, z);
      if (now != State::just_left) continue;
      now = State::fluid;
      if (is_own(x, y, z)) uncovered_.push_back(changed_cell(covered, x, y, z));
    }
  });
}

void Coverage::find_runs(std::span<const BeadOnLattice> beads) {
  now_.images.clear();
  now_.runs.clear();
  for (int b = 0; b < std::ssize(beads); ++b) {
    const Vec3& centre = beads[b].motion.position;
    for_each_image(block_in_lattice_, margin, centre, beads[b].radius, [&](const BeadImage& image) {
      const CoveredImage& covered =
          now_.images.emplace_back(CoveredImage{.image = image,
                                                .index = static_cast<int>(now_.images.size()),
                                                .bead = b,
                                                .centre = centre,
                                                .radius = beads[b].radius,
                                                .first_run = static_cast<int>(now_.runs.size())});
      for (int z = image.low[2]; z < image.high[2]; ++z) {
        for (int y = image.low[1]; y < image.high[1]; ++y) now_.runs.push_back(covered_run(covered, y, z));
      }
    });
  }
  now_.close_pairs = find_close_pairs(now_.images);
  for (const ImagePair& pair : now_.close_pairs) part(now_.images[pair.first], now_.images[pair.second]);
}

/// Divides the cells that lie inside both beads between the two beads.
void Coverage::part(const CoveredImage& first, const CoveredImage& second) {
  const BeadImage &a = first.image, &b = second.image;
  if (!are_close(a, b, 0)) return;
  const auto run = [&](const CoveredImage& covered, int y, int z) -> CoveredRun& {
    return now_.runs[covered.first_run + CoveredImages::run_index(covered, y, z)];
  };
  for (int z = std::max(a.low[2], b.low[2]); z < std::min(a.high[2], b.high[2]); ++z) {
    for (int y = std::max(a.low[1], b.low[1]); y < std::min(a.high[1], b.high[1]); ++y)
      part_row(first, run(first, y, z), second, run(second, y, z), y, z);
  }
}

void Coverage::cover_run(const CoveredImage& covered, const CoveredRun& run, int y, int z) {
  for (int x = run.low; x < run.high; ++x) {
    State& now = state(x, y, z);
    if (now == State::fluid && is_own(x, y, z)) newly_covered_.push_back(changed_cell(covered, x, y, z));
    now = State::covered;
  }
}

}  // namespace beadswim
