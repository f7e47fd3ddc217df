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
  int row;             ///< index of the row: y + (rows along y) z
  int bead;            ///< index into the beads
  int first_fraction;  ///< index of the fraction of cell `low`
  int shift;           ///< cell x is cell x + shift in the unwrapped coordinates of the bead
  double centre;       ///< x of the centre of the bead, unwrapped [cell]
  double y, z;         ///< centres of the cells relative to the centre of the bead [cell]

  bool contains(int x) const { return x >= low && x < high; }

  /// Returns the centre of a cell relative to the centre of the bead, with the same bits in every block.
  Vec3 from_centre(int x) const { return {x + shift + 0.5 - centre, y, z}; }
};

/// Cells of a block that beads touch, with the fractions that the beads fill. The fractions are exact, so
/// that their sum over a bead is the volume of the bead.
class SaturatedCells {
 public:
  explicit SaturatedCells(const BlockInLattice& lattice_block);

  /// Finds the cells and fractions for the present positions of `beads`.
  void find(std::span<const BeadOnLattice> beads);

  /// Returns the runs in row (y, z) of the block, in the order of the beads.
  std::span<const SaturatedRun> runs(int y, int z) const {
    const int row = row_index(y, z);
    return std::span(runs_).subspan(first_of_row_[row], first_of_row_[row + 1] - first_of_row_[row]);
  }

  /// Returns the fraction of cell x of a run that the bead fills.
  double fraction(const SaturatedRun& run, int x) const {
    return fractions_[run.first_fraction + x - run.low];
  }

 private:
  /// Volumes that the planes between cells cut off one image of a bead (sphere_overlap.hpp).
  struct Cuts {
    std::array<std::vector<double>, 3> planes;      ///< positions relative to the centre, along each axis
    std::array<std::vector<double>, 3> beyond_one;  ///< q(a) of each plane
    std::array<std::vector<double>, 3>
        beyond_two;  ///< [axis]: q(a, b) of the other two axes, later axis slowest
  };

  int row_index(int y, int z) const { return y + block_in_lattice_.block.size[1] * z; }
  void find_of_image(int bead, const Vec3& centre, double radius, const BeadImage& image);
  void find_of_row(const SaturatedRun& row, double radius, const BeadImage& image, int y, int z);
  void cut(const Vec3& centre, double radius, const BeadImage& image);
  double volume_below(int x, int y, int z, double radius) const;
  void sort_by_row();

  BlockInLattice block_in_lattice_;
  Cuts cuts_;
  std::vector<SaturatedRun> found_, runs_;
  std::vector<int> first_of_row_, next_of_row_;
  std::vector<double> fractions_;
};

}  // namespace beadswim
