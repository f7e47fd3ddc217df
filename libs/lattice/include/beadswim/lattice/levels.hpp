#pragma once

#include <array>
#include <functional>
#include <memory>
#include <set>
#include <span>
#include <vector>

#include "beadswim/core/box.hpp"
#include "beadswim/core/communicator.hpp"
#include "beadswim/core/fields.hpp"
#include "beadswim/lattice/block.hpp"
#include "beadswim/lattice/halo.hpp"
#include "beadswim/lattice/populations.hpp"
#include "beadswim/lattice/totals.hpp"
#include "beadswim/lattice/trt.hpp"

namespace beadswim {

/// Place of a level of cells in the box, in coordinates of its own cells.
struct LevelPlace {
  Block lattice;                       ///< cells of the level
  Index3 box;                          ///< number of cells of this size along each edge of the box
  std::array<Boundary, 3> boundary{};  ///< boundaries of the box

  bool spans(int axis) const { return lattice.size[axis] == box[axis]; }
  /// Returns the periodic image of a cell that lies in the lattice or, if there is none, an image of the cell
  /// outside the lattice.
  Index3 in_lattice(Index3 cell) const {
    for (int a = 0; a < 3; ++a) {
      if (boundary[a] != Boundary::periodic) continue;
      const int from_first = (cell[a] - lattice.offset[a]) % box[a];
      cell[a] = lattice.offset[a] + (from_first < 0 ? from_first + box[a] : from_first);
    }
    return cell;
  }
  /// Returns true if the lattice contains the cell or a periodic image of it.
  bool contains(const Index3& cell) const { return lattice.contains(in_lattice(cell)); }
  /// Returns the parts of a block of this level that lie under a finer level, in local coordinates of the
  /// block, sorted by x: one part for each periodic image of the finer level, which may be empty.
  std::vector<Block> parts_under(const LevelPlace& finer, const Block& block) const;
  /// Returns true if the level is periodic along the axis.
  bool is_periodic(int axis) const { return boundary[axis] == Boundary::periodic && spans(axis); }
};

/// Cells of one size: a box of cells, divided among all ranks, and the populations of the block of this rank.
/// Its cells are 1 long, and its steps last 1.
struct Level {
  Level(const LevelPlace& place_of_level, double relaxation_time, Precision precision, HaloContent content,
        const Communicator& communicator);

  LevelPlace place;
  Decomposition decomposition;
  Block block;
  Populations populations;
  Halo halo;
  RelaxationRates rates;
  /// Cells of the block under the next finer level, which are not in use, in local coordinates, sorted by x.
  std::vector<Block> refined;
};

/// Returns the places of nested levels in a box of `cells` cells of the finest level. `lattices`: the cells
/// of each level, coarsest first.
std::vector<LevelPlace> places_in_box(const Index3& cells, const std::array<Boundary, 3>& boundary,
                                      std::span<const Block> lattices);

/// Impulse of the body force per volume on a level (body_force.hpp).
struct BodyImpulse {
  Vec3 pending = Vec3::Zero();  ///< for the next step of the level, with the rounding errors of earlier steps
  Vec3 acted = Vec3::Zero();    ///< impulse of the last step

  BEADSWIM_FIELDS(pending, acted)
};

class LevelInterface;

/// The fluid on nested levels of cells. Each level has cells of half the size of the next coarser level and
/// makes two steps in one step of it. Velocity and density have the same values on all levels, in lattice
/// units of each level.
class Levels {
 public:
  /// `places`: the levels, coarsest first; each lies inside the one before. `relaxation_time`:
  /// relaxation time of the finest level. `content`: halo of the finest level.
  Levels(const std::vector<LevelPlace>& places, double relaxation_time, Precision precision,
         HaloContent content, const Communicator& communicator);
  ~Levels();

  /// Sets the velocities of the no-slip walls at the ends of each axis, which are zero by default (lattice
  /// units).
  void set_wall_velocities(const std::array<WallVelocities, 3>& walls);

  int count() const { return static_cast<int>(levels_.size()); }
  Level& operator[](int n) { return *levels_[n]; }  ///< 0: the coarsest
  const Level& operator[](int n) const { return *levels_[n]; }
  Level& finest() { return *levels_.back(); }
  const Level& finest() const { return *levels_.back(); }

  /// Returns the velocity of a cell of level n [cell/step]. The populations contain the whole impulse of the
  /// body force in the last step; half of it belongs to the velocity.
  Vec3 velocity(int n, std::ptrdiff_t cell) const {
    return cell_moments(levels_[n]->populations, cell).momentum - 0.5 * impulses_[n].acted;
  }
  /// Returns half of the impulse of the body force in the last step of each level, summed over the box, in
  /// lattice units of the finest level.
  Vec3 half_impulse() const;

  /// Impulses of the body force, one per level: part of the state between two steps.
  const std::vector<BodyImpulse>& body_impulses() const { return impulses_; }
  void set_body_impulses(std::vector<BodyImpulse> impulses) {
    impulses_ = std::move(impulses);
    impulses_.resize(levels_.size());
  }

  /// Makes one step of the finest level, and the steps of coarser levels that are then due. Calls
  /// before_row(y, z) before it sweeps a row of the finest level (StepCallbacks); it may be empty.
  /// body_force: momentum that each cell of the finest level gains in this step. What acting_body_force()
  /// rounds off acts in later steps.
  void step(const Vec3& body_force, const std::function<void(int y, int z)>& before_row);

  /// Returns the totals of this rank outside the finest level, in the form that sum_of_coarser() needs.
  /// Throws SolverError if a number is non-finite.
  std::vector<FluidTotals> coarser_totals() const;
  /// Returns the mass (minus that at density 1) and the momentum of the fluid outside the finest level, and
  /// the pending impulses of the body force, in lattice units of the finest level. Between two steps of a
  /// coarser level, populations that have crossed its interface are counted on the side to which they have
  /// moved. `totals`: coarser_totals() of this rank; if it is empty, the rank counts as zero. Collective.
  CellMoments sum_of_coarser(std::vector<FluidTotals> totals, const Communicator& communicator) const;

  Traffic traffic() const;
  /// Returns the other ranks that exchange populations with this rank.
  std::set<int> neighbours() const;

 private:
  /// Returns the volume of level n outside the next finer level [cell of the finest level].
  double volume(int n) const;

  /// Makes one step of level n, and of the coarser level if it is due.
  void advance(int n, const std::function<void(int y, int z)>& before_row);

  std::vector<std::unique_ptr<Level>> levels_;               ///< coarsest first
  std::vector<std::unique_ptr<LevelInterface>> interfaces_;  ///< interface n joins levels n and n + 1
  std::vector<BodyImpulse> impulses_;                        ///< one per level
};

/// Sets all populations of `to` from those of `from`, which covers the same box with other levels. The number
/// of levels must be equal, and all levels of `from` must have reached the same time. Cells of `from` that
/// are not in use are changed. Mass and momentum are conserved to roundoff.
///
/// Cells of a level that existed before keep their populations. Other cells take them from the next finer or
/// coarser level, at the place where both are equal in linear flow (level_interface.hpp). f* is a population
/// after collision and c its velocity:
///
///   finer to coarser   F*(X) = mean of the eight f* in X + (c/2).grad f*     [cell of the finer level]
///   coarser to finer   f*(x) = F*(X) + (s - c/4).grad F*                     [cell of the coarser level]
///
/// s is the centre of x relative to the centre of the coarser cell X. The terms with c must not change mass
/// and momentum of a cell; such changes, which are of second order, are subtracted. Collective.
void transfer(Levels& from, Levels& to, const Communicator& communicator);

}  // namespace beadswim
