#pragma once

#include <functional>
#include <optional>

#include "beadswim/core/communicator.hpp"
#include "beadswim/lattice/block.hpp"
#include "beadswim/lattice/fluid_step.hpp"
#include "beadswim/lattice/halo.hpp"
#include "beadswim/lattice/populations.hpp"
#include "set_equilibrium.hpp"

namespace beadswim::test {

/// A box of fluid without beads. A uniform body force can act on the fluid.
struct FluidBox {
  FluidBox(const Index3& cells, const std::array<Boundary, 3>& boundary, double relaxation_time,
           MPI_Comm comm = MPI_COMM_SELF, Precision precision = Precision::fp64,
           HaloContent content = HaloContent::entering)
      : communicator(comm),
        decomposition(cells, communicator.size()),
        block(decomposition.block(communicator.rank())),
        populations(block.size, precision, content),
        halo(communicator, decomposition, boundary, content),
        rates(relaxation_rates(relaxation_time)) {}

  void step() {
    if (row_ends) {
      halo.start(populations);
      halo.finish(populations);
      stream_and_collide(populations, rates, *row_ends, body_force);
    } else {
      step_fluid(populations, halo, rates, body_force);
    }
  }

  void steps(int count) {
    for (int n = 0; n < count; ++n) step();
  }

  /// Returns the velocity at a cell in the middle of a time step: half of the force's impulse before the
  /// value after the collision.
  Vec3 velocity(int x, int y, int z) const {
    return cell_moments(populations, populations.cell(x, y, z)).momentum - 0.5 * body_force;
  }

  /// Sets every cell of this rank to equilibrium, with density - 1 and velocity as `state` returns them for
  /// its global coordinates.
  void set(const std::function<CellMoments(const Index3&)>& state) {
    for_each_cell(populations, [&](const Index3& p, std::ptrdiff_t cell) {
      const CellMoments moments = state(p + block.offset);
      set_equilibrium(populations, cell, moments.density_deviation, moments.momentum);
    });
  }

  Communicator communicator;
  Decomposition decomposition;
  Block block;
  Populations populations;
  Halo halo;
  RelaxationRates rates;
  Vec3 body_force = Vec3::Zero();
  std::optional<RowEnds> row_ends;  ///< row ends that the sweep fills; nullopt: all possible ones
};

}  // namespace beadswim::test
