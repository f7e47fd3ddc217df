#pragma once

#include <array>
#include <span>
#include <vector>

#include "beadswim/coupling/bead_images.hpp"
#include "beadswim/coupling/bead_on_lattice.hpp"
#include "beadswim/coupling/impulse_sums.hpp"
#include "beadswim/lattice/populations.hpp"

namespace beadswim {

/// Consecutive cells [low, high) of a row of the block, in local coordinates, that one image of a bead
/// touches.
struct SaturatedRun {
  int low, high;
  int row;             ///< index of the row: y + (rows along y) z
  int bead;            ///< index into the list of beads
  int first_fraction;  ///< index of the fraction of cell `low` in the list of all fractions
  int shift;  ///< cell x has its centre at x + shift + 1/2 in the unwrapped coordinates of the bead [cell]
  double centre;  ///< x of the centre of the bead, unwrapped [cell]
  double y, z;    ///< y, z of the cell centres relative to the centre of the bead [cell]

  bool contains(int x) const { return x >= low && x < high; }

  /// Returns the centre of a cell relative to the centre of the bead, with the same bits in every block.
  Vec3 from_centre(int x) const { return {x + shift + 0.5 - centre, y, z}; }
};

/// Force of beads on the fluid in a saturated cell in one step, in lattice units.
struct SaturatedForce {
  std::ptrdiff_t cell;    ///< index in the populations
  double fluid_fraction;  ///< fraction of the cell that no bead fills
  Vec3 force;             ///< momentum that the fluid gained
};

/// Saturated cells of a block: cells that beads cover partly or completely, with the fraction of each cell
/// that a bead fills. The fractions are exact, so that their sum over the cells of a bead is the volume of
/// the bead [cell^3]. The equations for one cell are in saturated_cell.hpp.
class SaturatedCells {
 public:
  /// `viscosity`: kinematic viscosity of the fluid [cell^2/step].
  SaturatedCells(const BlockInLattice& lattice_block, double viscosity);

  /// Finds the cells and fractions for the present positions of `beads`.
  void find(std::span<const BeadOnLattice> beads);

  /// Begins a step in which each cell gains the momentum `body_force` at the end of the step. Half of it
  /// belongs to the momentum v that the force of a bead drives to the velocity of the bead, so this force
  /// acts as if the bead were slower by this half.
  void begin_step(const Vec3& body_force);

  /// Applies the forces of beads on the fluid in the cells of row (y, z) of the block, by changing the
  /// incoming populations of these cells. step_fluid() must call this function before each row. The function
  /// uses incoming populations of this row only. `beads`: those for which the cells were found; adds to the
  /// stress of their impulse.
  void apply_forces_before_row(Populations& populations, std::span<BeadOnLattice> beads, int y, int z);

  /// Adds the impulse and angular impulse on each bead since the last call, and the momentum and angular
  /// momentum of the fluid within it, to BeadOnLattice::impulse.
  void transfer_impulses(std::span<BeadOnLattice> beads);

  /// Returns the forces of the last step. Half of a force belongs to the velocity of its cell.
  const std::vector<SaturatedForce>& forces() const { return forces_; }

  /// Returns the runs of touched cells in row (y, z) of the block, in the order of the beads.
  std::span<const SaturatedRun> runs(int y, int z) const {
    const int row = row_index(y, z);
    return std::span(runs_).subspan(first_of_row_[row], first_of_row_[row + 1] - first_of_row_[row]);
  }

  /// Returns the fraction of cell x of a run that the bead fills.
  double fraction(const SaturatedRun& run, int x) const {
    return fractions_[run.first_fraction + x - run.low];
  }

 private:
  /// Volumes that the planes between cells cut off from one image of a bead (sphere_overlap.hpp).
  struct Cuts {
    std::array<std::vector<double>, 3> planes;      ///< positions relative to the centre, along each axis
    std::array<std::vector<double>, 3> beyond_one;  ///< volume q(a) beyond each plane
    /// Volume q(a, b) beyond two planes, for each pair of planes perpendicular to the two axes other than
    /// [axis]. The later axis varies slowest.
    std::array<std::vector<double>, 3> beyond_two;
  };

  int row_index(int y, int z) const { return y + block_in_lattice_.block.size[1] * z; }
  void find_of_image(int bead, const Vec3& centre, double radius, const BeadImage& image);
  void find_of_row(const SaturatedRun& row, double radius, const BeadImage& image, int y, int z);
  void cut(const Vec3& centre, double radius, const BeadImage& image);
  double volume_below(int x, int y, int z, double radius) const;
  void sort_by_row();
  template <class Real>
  class RowUpdate;

  BlockInLattice block_in_lattice_;
  Cuts cuts_;
  std::vector<SaturatedRun> found_, runs_;
  std::vector<int> first_of_row_, next_of_row_;
  std::vector<double> fractions_;
  double viscosity_;
  Vec3 body_force_ = Vec3::Zero();
  std::vector<SaturatedSums> sums_;  ///< one per bead; zero between steps
  std::vector<SaturatedForce> forces_;
};

}  // namespace beadswim
