#include "beadswim/coupling/saturated_cells.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "beadswim/coupling/sphere_overlap.hpp"

namespace beadswim {
namespace {

/// Squares of the smallest and of the largest distance between 0 and a point of the interval [low, low + 1].
struct Distances {
  double nearest, farthest;
};
Distances squared_distances(double low) {
  const double high = low + 1;
  const double nearest = low > 0 ? low : (high < 0 ? high : 0);
  const double farthest = std::max(-low, high);
  return {nearest * nearest, farthest * farthest};
}

}  // namespace

SaturatedCells::SaturatedCells(const BlockInLattice& lattice_block, double viscosity)
    : block_in_lattice_(lattice_block),
      first_of_row_(lattice_block.block.size[1] * lattice_block.block.size[2] + 1, 0),
      viscosity_(viscosity) {}

void SaturatedCells::find(std::span<const BeadOnLattice> beads) {
  found_.clear();
  fractions_.clear();
  sums_.resize(beads.size());
  for (int b = 0; b < std::ssize(beads); ++b) {
    const Vec3& centre = beads[b].motion.position;
    // for_each_image() finds cells whose centre lies within the radius. A bead also touches cells whose
    // centre lies up to half a cell farther out along an axis.
    for_each_image(block_in_lattice_, 0, centre, beads[b].radius + 0.5,
                   [&](const BeadImage& image) { find_of_image(b, centre, beads[b].radius, image); });
  }
  sort_by_row();
}

void SaturatedCells::find_of_image(int bead, const Vec3& centre, double radius, const BeadImage& image) {
  cut(centre, radius, image);
  for (int z = image.low[2]; z < image.high[2]; ++z) {
    for (int y = image.low[1]; y < image.high[1]; ++y) {
      find_of_row({.low = image.low[0],
                   .high = image.high[0],
                   .row = row_index(y, z),
                   .bead = bead,
                   .first_fraction = static_cast<int>(fractions_.size()),
                   .shift = image.shift[0],
                   .centre = centre[0],
                   .y = y + image.shift[1] + 0.5 - centre[1],
                   .z = z + image.shift[2] + 0.5 - centre[2]},
                  radius, image, y - image.low[1], z - image.low[2]);
    }
  }
}

/// Finds the touched cells of one row. row: all cells of the row in the box of the image; y, z: coordinates
/// of the row relative to the low corner of the box.
void SaturatedCells::find_of_row(const SaturatedRun& row, double radius, const BeadImage& image, int y,
                                 int z) {
  const double radius_squared = radius * radius;
  const auto along_x = [&](int x) { return squared_distances(cuts_.planes[0][x - image.low[0]]); };
  const Distances along_y = squared_distances(cuts_.planes[1][y]);
  const Distances along_z = squared_distances(cuts_.planes[2][z]);
  const double nearest = along_y.nearest + along_z.nearest, farthest = along_y.farthest + along_z.farthest;
  const auto is_touched = [&](int x) { return along_x(x).nearest + nearest < radius_squared; };
  const auto is_full = [&](int x) { return along_x(x).farthest + farthest <= radius_squared; };

  SaturatedRun run = row;
  while (run.low < run.high && !is_touched(run.low)) ++run.low;
  while (run.low < run.high && !is_touched(run.high - 1)) --run.high;
  if (run.low == run.high) return;

  // Returns the signed volume of the bead within this row of cells, between its centre and a plane across x.
  const auto below = [&](int plane) {
    const int x = plane - image.low[0];
    return volume_below(x, y + 1, z + 1, radius) - volume_below(x, y, z + 1, radius) -
           volume_below(x, y + 1, z, radius) + volume_below(x, y, z, radius);
  };
  int known_plane = run.low;
  double known = below(known_plane);
  for (int x = run.low; x < run.high; ++x) {
    if (is_full(x)) {
      fractions_.push_back(1);
      continue;
    }
    const double low = known_plane == x ? known : below(x);
    known_plane = x + 1;
    known = below(known_plane);
    fractions_.push_back(std::clamp(known - low, 0.0, 1.0));
  }
  found_.push_back(run);
}

void SaturatedCells::cut(const Vec3& centre, double radius, const BeadImage& image) {
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<double>& planes = cuts_.planes[axis];
    std::vector<double>& beyond = cuts_.beyond_one[axis];
    planes.clear();
    beyond.clear();
    for (int p = image.low[axis]; p <= image.high[axis]; ++p) {
      planes.push_back(p + image.shift[axis] - centre[axis]);
      beyond.push_back(octant_beyond(std::abs(planes.back()), radius));
    }
  }
  for (int axis = 0; axis < 3; ++axis) {
    const int first = axis == 0 ? 1 : 0, second = axis == 2 ? 1 : 2;
    std::vector<double>& beyond = cuts_.beyond_two[axis];
    beyond.clear();
    for (const double b : cuts_.planes[second]) {
      for (const double a : cuts_.planes[first])
        beyond.push_back(octant_beyond(std::abs(a), std::abs(b), radius));
    }
  }
}

/// Returns C(a, b, c), the signed volume of the bead between its centre and the corner (a, b, c) at which
/// three planes between cells intersect (sphere_overlap.hpp). x, y, z: indices of the planes in cuts_.planes.
double SaturatedCells::volume_below(int x, int y, int z, double radius) const {
  const auto& [planes, one, two] = cuts_;
  const std::size_t nx = planes[0].size(), ny = planes[1].size();
  return corner_volume(planes[0][x], planes[1][y], planes[2][z], radius,
                       {.beyond_one = one[0][x] + one[1][y] + one[2][z],
                        .beyond_two = two[0][y + ny * z] + two[1][x + nx * z] + two[2][x + nx * y]});
}

void SaturatedCells::sort_by_row() {
  std::ranges::fill(first_of_row_, 0);
  for (const SaturatedRun& run : found_) ++first_of_row_[run.row + 1];
  std::partial_sum(first_of_row_.begin(), first_of_row_.end(), first_of_row_.begin());
  next_of_row_ = first_of_row_;
  runs_.resize(found_.size());
  for (const SaturatedRun& run : found_) runs_[next_of_row_[run.row]++] = run;
}

}  // namespace beadswim
