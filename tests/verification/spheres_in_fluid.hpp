#pragma once

#include <vector>

#include "beadswim/core/communicator.hpp"
#include "beadswim/coupling/bead_boundary.hpp"
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
  SpheresInFluid(const Index3& cells, double relaxation_time, LinkScheme scheme,
                 const std::vector<Sphere>& spheres);

  /// Sets all fluid to equilibrium at this velocity.
  void start_fluid(const Vec3& velocity);

  /// One step of the fluid, spheres where they are. Returns what it handed to each sphere: impulses at the
  /// links, and momentum of cells that changed hands in the last move().
  std::vector<Load> step();

  /// Moves every sphere by its velocity. Cells change hands.
  void move();

  BeadMotion& motion(int sphere) { return beads_[sphere].motion; }
  const BeadMotion& motion(int sphere) const { return beads_[sphere].motion; }

  /// Acceleration of each fluid cell in the coming steps [cell/step^2]. Of a step's impulse half belongs to
  /// its middle: the fluid's momentum then is fluid_momentum() - body_force fluid_cells()/2.
  Vec3 body_force = Vec3::Zero();

  /// The body force of the next step that keeps the fluid's momentum near `momentum`: what spheres took in
  /// the mean of the last two steps (a staircase answers alternate steps differently, which following single
  /// steps would amplify), and a small part of what is missing.
  void hold_fluid_momentum(const Vec3& momentum);

  /// By the books: start + body forces - all that was handed to spheres.
  const Vec3& fluid_momentum() const { return fluid_momentum_; }

  /// The same and the mass beyond density 1, counted over all fluid cells.
  CellMoments counted_fluid() const;
  /// Fluid mass beyond density 1 that spheres hold.
  double held_mass() const;

  long fluid_cells() const { return fluid_cells_; }
  double volume() const { return cells_.cast<double>().prod(); }

 private:
  void accelerate_row(int y, int z);
  void count_fluid_cells();

  Index3 cells_;
  Communicator self_{MPI_COMM_SELF};
  Decomposition decomposition_;
  Populations populations_;
  Halo halo_;
  RelaxationRates rates_;
  Coverage coverage_;
  BeadLinks links_;
  std::vector<BeadOnLattice> beads_;
  std::vector<LinkSums> sums_;
  std::vector<double> held_mass_;  ///< one a bead
  Vec3 fluid_momentum_ = Vec3::Zero();
  Vec3 taken_ = Vec3::Zero(), taken_before_ = Vec3::Zero();  ///< by spheres, in the last two steps
  long fluid_cells_ = 0;
};

}  // namespace beadswim::verification
