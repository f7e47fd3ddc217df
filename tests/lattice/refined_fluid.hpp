#pragma once

#include <cmath>
#include <functional>
#include <vector>

#include "beadswim/core/communicator.hpp"
#include "beadswim/lattice/levels.hpp"
#include "set_equilibrium.hpp"

namespace beadswim::test {

/// A cell of one of several levels.
struct LevelCell {
  int level;
  std::ptrdiff_t cell;  ///< index in the populations of the level
  Vec3 centre;          ///< position of its centre [coarsest cell]
  double volume;        ///< [coarsest cell^3]
};

/// A box of fluid without beads on nested levels of cells.
struct RefinedFluid {
  /// `cells`: coarsest cells of the box; `finer`: the other levels in coordinates of their own cells;
  /// `relaxation_time`: that of the coarsest level.
  RefinedFluid(const Index3& cells, const std::vector<Block>& finer, double relaxation_time,
               const std::array<Boundary, 3>& boundary, Precision precision = Precision::fp64,
               MPI_Comm comm = MPI_COMM_SELF)
      : communicator(comm),
        levels(places(cells, finer, boundary),
               0.5 + std::ldexp(relaxation_time - 0.5, static_cast<int>(finer.size())), precision,
               HaloContent::entering, communicator) {}

  /// Makes `count` steps of the coarsest level.
  void steps(int count) {
    for (int n = 0; n < count << (levels.count() - 1); ++n) levels.step(body_force, [](int, int) {});
  }

  /// Calls visit(LevelCell) for all cells in use of this rank.
  template <class Visit>
  void for_each_used_cell(Visit&& visit) const {
    for (int n = 0; n < levels.count(); ++n) {
      const Level& level = levels[n];
      const double edge = std::ldexp(1.0, -n);
      for (int z = 0; z < level.block.size[2]; ++z) {
        for (int y = 0; y < level.block.size[1]; ++y) {
          for_each_run_outside(level.refined, level.block.size[0], y, z, [&](int x, int end) {
            for (; x < end; ++x) {
              const Index3 place = Index3(x, y, z) + level.block.offset;
              visit(LevelCell{.level = n,
                              .cell = level.populations.cell(x, y, z),
                              .centre = edge * (place.cast<double>() + 0.5).matrix(),
                              .volume = edge * edge * edge});
            }
          });
        }
      }
    }
  }

  /// Sets every cell to equilibrium, with density - 1 and velocity as `state` returns them for its centre.
  void set(const std::function<CellMoments(const Vec3&)>& state) {
    for_each_used_cell([&](const LevelCell& at) {
      const CellMoments moments = state(at.centre);
      set_equilibrium(levels[at.level].populations, at.cell, moments.density_deviation, moments.momentum);
    });
  }

  CellMoments moments(const LevelCell& at) const {
    return cell_moments(levels[at.level].populations, at.cell);
  }

  /// Returns the relative L2 error of the velocity, and the largest error relative to `speed`.
  struct Error {
    double root_mean_square = 0, largest = 0;
  };
  Error error(const std::function<Vec3(const Vec3&)>& exact, double speed) const {
    double square = 0, scale = 0, largest = 0;
    for_each_used_cell([&](const LevelCell& at) {
      const Vec3 u = exact(at.centre), difference = levels.velocity(at.level, at.cell) - u;
      square += at.volume * difference.squaredNorm();
      scale += at.volume * u.squaredNorm();
      largest = std::max(largest, difference.norm() / speed);
    });
    return {.root_mean_square = std::sqrt(square / scale), .largest = largest};
  }

  Communicator communicator;
  Levels levels;
  Vec3 body_force = Vec3::Zero();  ///< in a step of the finest level

 private:
  static std::vector<LevelPlace> places(const Index3& cells, const std::vector<Block>& finer,
                                        const std::array<Boundary, 3>& boundary) {
    std::vector<Block> lattices{{.offset = Index3::Zero(), .size = cells}};
    lattices.insert(lattices.end(), finer.begin(), finer.end());
    return places_in_box(cells * (1 << finer.size()), boundary, lattices);
  }
};

}  // namespace beadswim::test
