#pragma once

#include <array>
#include <span>
#include <vector>

#include "beadswim/coupling/bead_images.hpp"
#include "beadswim/coupling/bead_on_lattice.hpp"

namespace beadswim {

/// Cells [low, high) of a row of the block, in local coordinates, that one image of a bead touches.
struct SaturatedRun {
  int low, high;
  int row;             ///< y + rows along y * z
  int bead;            ///< index into the beads
  int first_fraction;  ///< among the fractions
  int shift;           ///< cell x is cell x + shift in the bead's own unwrapped coordinates
  double centre;       ///< x of the bead, unwrapped
  double y, z;         ///< of the cells' centres relative to the bead's

  bool contains(int x) const { return x >= low && x < high; }

  /// Centre of a cell relative to that of the bead: the same bits whichever block asks.
  Vec3 from_centre(int x) const { return {x + shift + 0.5 - centre, y, z}; }
};

/// Which of a block's cells beads touch, and what fraction of each they fill: exactly, so that the fractions
/// of a bead add up to its volume.
class SaturatedCells {
 public:
  explicit SaturatedCells(const BlockInLattice& at);

  /// Finds them anew for the beads where they are now.
  void find(std::span<const BeadOnLattice> beads);

  /// The runs in row (y, z) of the block, in order of the beads.
  std::span<const SaturatedRun> runs(int y, int z) const {
    const int row = row_index(y, z);
    return std::span(runs_).subspan(first_of_row_[row], first_of_row_[row + 1] - first_of_row_[row]);
  }

  /// Fraction of cell x, of a run, that the bead fills.
  double fraction(const SaturatedRun& run, int x) const {
    return fractions_[run.first_fraction + x - run.low];
  }

 private:
  /// What the planes between cells cut off a bead, of one image.
  struct Cuts {
    std::array<std::vector<double>, 3> planes;      ///< their distances from the centre, along each axis
    std::array<std::vector<double>, 3> beyond_one;  ///< q(a) of each
    std::array<std::vector<double>, 3>
        beyond_two;  ///< [axis]: q of pairs of the other two, the later slowest
  };

  int row_index(int y, int z) const { return y + at_.block.size[1] * z; }
  void find_of_image(int bead, const Vec3& centre, double radius, const BeadImage& image);
  void find_of_row(const SaturatedRun& row, double radius, const BeadImage& image, int y, int z);
  void cut(const Vec3& centre, double radius, const BeadImage& image);
  double volume_below(int x, int y, int z, double radius) const;
  void sort_by_row();

  BlockInLattice at_;
  Cuts cuts_;
  std::vector<SaturatedRun> found_, runs_;
  std::vector<int> first_of_row_, next_of_row_;
  std::vector<double> fractions_;
};

}  // namespace beadswim
