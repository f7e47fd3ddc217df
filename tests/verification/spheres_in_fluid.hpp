#pragma once

#include <vector>

#include "beadswim/core/communicator.hpp"
#include "beadswim/coupling/bead_boundary.hpp"
#include "beadswim/coupling/saturated_boundary.hpp"
#include "beadswim/lattice/block.hpp"
#include "beadswim/lattice/fluid_step.hpp"

namespace beadswim::verification {

struct Sphere {
  double radius = 0;  ///< [cell]
  Vec3 centre = Vec3::Zero();
};

/// Spheres in a periodic box of fluid on one rank: an infinite array. Who uses it moves them: it says how
/// they turn and translate and asks for what the fluid hands to them. Lattice units.
///
/// All that these cases know of how beads and fluid are coupled is here. The order of a step is that of
/// coupled_step.cpp, beads' equation of motion left out, a uniform body force put in.
class SpheresInFluid {
 public:
  /// Fluid and spheres at rest.
  SpheresInFluid(const Index3& cells, double relaxation_time, BeadScheme scheme,
                 const std::vector<Sphere>& spheres);

  /// Sets all fluid to equilibrium at this velocity.
  void start_fluid(const Vec3& velocity);

  /// One step of the fluid, spheres where they are. Returns what it handed to each sphere: impulses at the
  /// links, and momentum of cells that changed hands in the last move(); or, of saturated cells, what they
  /// give up, without the fluid inside.
  std::vector<Load> step();

  /// Moves every sphere by its velocity. Cells change hands.
  void move();

  BeadMotion& motion(int sphere) { return beads_[sphere].motion; }
  const BeadMotion& motion(int sphere) const { return beads_[sphere].motion; }

  /// Acceleration of each fluid cell in the coming steps [cell/step^2].
  Vec3 body_force = Vec3::Zero();

  /// The body force of the next step that keeps the fluid's momentum near `momentum`: what spheres took in
  /// the mean of the last two steps (a staircase answers alternate steps differently, which following single
  /// steps would amplify), and a small part of what is missing.
  void hold_fluid_momentum(const Vec3& momentum);

  /// By the books: start + body forces - all that was handed to spheres.
  const Vec3& fluid_momentum() const { return fluid_momentum_; }
  /// In the middle of the last step: without half of the body force's impulse, and of the force in saturated
  /// cells.
  Vec3 mid_step_momentum() const {
    return fluid_momentum_ - 0.5 * (fluid_cells_ * body_force + force_on_fluid_part_);
  }

  /// The same and the mass beyond density 1, counted over all fluid cells.
  CellMoments counted_fluid() const;
  /// Fluid mass beyond density 1 that spheres hold.
  double held_mass() const;

  /// How many, or, where spheres fill parts of cells, their volume.
  double fluid_cells() const { return fluid_cells_; }
  double volume() const { return cells_.cast<double>().prod(); }

 private:
  void accelerate_row(int y, int z);
  void push_row(int y, int z);
  void place_spheres();
  Load take_load(int sphere);

  Index3 cells_;
  Communicator self_{MPI_COMM_SELF};
  Decomposition decomposition_;
  Populations populations_;
  Halo halo_;
  RelaxationRates rates_;
  Coverage coverage_;
  BeadLinks links_;
  SaturatedCells saturated_cells_;
  std::vector<BeadOnLattice> beads_;
  std::vector<LinkSums> sums_;
  std::vector<SaturatedSums> saturated_sums_;
  std::vector<Load> inner_momentum_;         ///< of the fluid in each sphere, with saturated cells
  Vec3 force_on_fluid_part_ = Vec3::Zero();  ///< of the spheres on what is outside them, likewise
  std::vector<double> held_mass_;            ///< one a bead
  Vec3 fluid_momentum_ = Vec3::Zero();
  Vec3 taken_ = Vec3::Zero(), taken_before_ = Vec3::Zero();  ///< by spheres, in the last two steps
  double fluid_cells_ = 0;
};

}  // namespace beadswim::verification
