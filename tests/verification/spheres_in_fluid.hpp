#pragma once

#include <vector>

#include "beadswim/core/communicator.hpp"
#include "beadswim/coupling/bead_links.hpp"
#include "beadswim/coupling/saturated_cells.hpp"
#include "beadswim/lattice/block.hpp"
#include "beadswim/lattice/fluid_step.hpp"

namespace beadswim::verification {

struct Sphere {
  double radius = 0;  ///< [cell]
  Vec3 centre = Vec3::Zero();
};

/// Spheres in a periodic box of fluid on one rank, which are an infinite array. The measurement prescribes
/// how the spheres translate and rotate, and obtains the impulses that the fluid transfers to them. All
/// quantities are in lattice units.
///
/// This class contains everything that the measurements know about the coupling of beads and fluid. The order
/// within a time step is that of coupled_step.cpp, without the equation of motion of the beads and with a
/// uniform body force.
class SpheresInFluid {
 public:
  /// Makes fluid and spheres at rest.
  SpheresInFluid(const Index3& cells, double relaxation_time, BeadScheme scheme,
                 const std::vector<Sphere>& spheres);

  /// Sets all fluid to equilibrium with this velocity.
  void start_fluid(const Vec3& velocity);

  /// Performs one step of the fluid; the spheres stay at their positions. Returns the impulse that the fluid
  /// transferred to each sphere. With links: impulses at the links, and the momentum of cells that changed
  /// between fluid and sphere in the last move(). With saturated cells: the momentum that they lose, without
  /// the fluid inside the sphere.
  std::vector<Load> step();

  /// Moves every sphere by its velocity. Cells can change between fluid and sphere.
  void move();

  BeadMotion& motion(int sphere) { return beads_[sphere].motion; }
  const BeadMotion& motion(int sphere) const { return beads_[sphere].motion; }

  /// Acceleration of each fluid cell in the coming steps [cell/step^2].
  Vec3 body_force = Vec3::Zero();

  /// Sets the body force of the next step such that the fluid keeps about the given momentum. The body force
  /// replaces the momentum that the spheres received, as mean of the last two steps, and a small part of the
  /// missing momentum. The mean is needed because the staircase scheme reacts differently in alternate steps,
  /// which a force from single steps would amplify.
  void hold_fluid_momentum(const Vec3& momentum);

  /// Returns the momentum of the fluid by summation: initial momentum + body forces - momentum transferred to
  /// the spheres.
  const Vec3& fluid_momentum() const { return fluid_momentum_; }
  /// Returns the momentum of the fluid in the middle of the last step: without half of the impulse of the
  /// body force and of the force in saturated cells.
  Vec3 mid_step_momentum() const {
    return fluid_momentum_ - 0.5 * (fluid_cells_ * body_force + force_on_fluid_part_);
  }

  /// Returns the momentum of the fluid and its mass beyond density 1, summed over all fluid cells.
  CellMoments counted_fluid() const;
  /// Returns the fluid mass beyond density 1 that the spheres hold.
  double held_mass() const;

  /// Returns the number of fluid cells, or, with saturated cells, the volume of the fluid in cells.
  double fluid_cells() const { return fluid_cells_; }
  double volume() const { return cells_.cast<double>().prod(); }

 private:
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
  std::vector<Load> inner_momentum_;         ///< momentum of the fluid in each sphere (psm)
  Vec3 force_on_fluid_part_ = Vec3::Zero();  ///< force on the fluid outside the spheres (psm)
  std::vector<double> held_mass_;            ///< one element per bead
  Vec3 fluid_momentum_ = Vec3::Zero();
  Vec3 taken_ = Vec3::Zero(), taken_before_ = Vec3::Zero();  ///< impulses to spheres, last two steps
  double fluid_cells_ = 0;
};

}  // namespace beadswim::verification
