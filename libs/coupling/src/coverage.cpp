#include "beadswim/coupling/coverage.hpp"

#include <fmt/core.h>

#include "beadswim/core/error.hpp"

namespace beadswim {

Coverage::Coverage(const BlockInLattice& at, const Populations& populations)
    : at_(at),
      pitch_y_(populations.pitch(1)),
      pitch_z_(populations.pitch(2)),
      origin_(populations.cell(0, 0, 0)),
      bead_at_(populations.cell_indices(), fluid) {}

void Coverage::update(std::span<const BeadOnLattice> beads) {
  for (const CoveredCell& covered : cells_) bead_at_[covered.cell] = fluid;
  cells_.clear();
  for (int b = 0; b < std::ssize(beads); ++b) {
    for_each_image(at_, 1, beads[b].motion.position, beads[b].radius,
                   [&](const BeadImage& image) { cover(beads, b, image); });
  }
}

void Coverage::cover(std::span<const BeadOnLattice> beads, int bead, const BeadImage& image) {
  const Vec3& centre = beads[bead].motion.position;
  const double radius_squared = beads[bead].radius * beads[bead].radius;
  for (int z = image.low[2]; z < image.high[2]; ++z) {
    for (int y = image.low[1]; y < image.high[1]; ++y) {
      for (int x = image.low[0]; x < image.high[0]; ++x) {
        // From whole numbers in the bead's own coordinates: the same bits whichever block asks.
        const Vec3 from_centre(x + image.shift[0] + 0.5 - centre[0], y + image.shift[1] + 0.5 - centre[1],
                               z + image.shift[2] + 0.5 - centre[2]);
        if (!(from_centre.squaredNorm() < radius_squared)) continue;
        const std::ptrdiff_t cell = origin_ + x + pitch_y_ * y + pitch_z_ * z;
        if (bead_at_[cell] != fluid) {
          const BeadName a = beads[bead_at_[cell]].name, b = beads[bead].name;
          throw SolverError(
              fmt::format("bead {} of swimmer {} and bead {} of swimmer {} overlap at ({:.2f}, {:.2f}, "
                          "{:.2f}) cells; weaker "
                          "driving or stiffer springs keep them apart",
                          a.bead + 1, a.swimmer, b.bead + 1, b.swimmer, centre[0], centre[1], centre[2]));
        }
        bead_at_[cell] = bead;
        cells_.push_back({.cell = cell, .local = {x, y, z}, .bead = bead, .from_centre = from_centre});
      }
    }
  }
}

}  // namespace beadswim
