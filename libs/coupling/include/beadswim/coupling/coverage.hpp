#pragma once

#include <span>
#include <vector>

#include "beadswim/coupling/bead_images.hpp"
#include "beadswim/coupling/bead_on_lattice.hpp"
#include "beadswim/lattice/populations.hpp"

namespace beadswim {

/// A cell whose centre lies inside a bead.
struct CoveredCell {
  std::ptrdiff_t cell;
  Index3 local;                  ///< coordinates in the block, -1 to size
  int bead;                      ///< index into the beads of the last update
  Vec3 from_centre;              ///< centre of the cell relative to the bead's (its image's) centre
  double density_deviation = 0;  ///< of the fluid around it; what it has when it is uncovered
};

/// The staircase: which cells of a block, and of its halo, are covered by which bead.
class Coverage {
 public:
  static constexpr int fluid = -1;

  Coverage(const BlockInLattice& at, const Populations& populations);

  /// Covers anew for the beads where they are now. Throws SolverError if two beads claim one cell.
  void update(std::span<const BeadOnLattice> beads);

  /// Index of the bead that covers a cell, or `fluid`.
  int bead_at(std::ptrdiff_t cell) const { return bead_at_[cell]; }

  std::vector<CoveredCell>& cells() { return cells_; }
  const std::vector<CoveredCell>& cells() const { return cells_; }

  bool is_own(const Index3& local) const { return (local >= 0).all() && (local < at_.block.size).all(); }
  bool is_in_halo_or_own(const Index3& local) const {
    return (local >= -1).all() && (local <= at_.block.size).all();
  }

 private:
  void cover(std::span<const BeadOnLattice> beads, int bead, const BeadImage& image);

  BlockInLattice at_;
  std::ptrdiff_t pitch_y_, pitch_z_, origin_;
  std::vector<int> bead_at_;
  std::vector<CoveredCell> cells_;
};

}  // namespace beadswim
