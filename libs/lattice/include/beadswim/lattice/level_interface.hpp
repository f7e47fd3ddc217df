#pragma once

#include <memory>
#include <set>

#include "beadswim/core/communicator.hpp"
#include "beadswim/core/traffic.hpp"
#include "beadswim/lattice/level.hpp"
#include "beadswim/lattice/totals.hpp"

// Exchange of populations between two levels of cells. The fine level has cells of half the size and makes
// two steps in one step of the coarse level. It lies inside the coarse level, on a box of whole coarse cells:
// the refined cells of the coarse level, which are not in use.
//
// A population that crosses the interface keeps its velocity for one coarse step. Let x be a fine cell, c
// the velocity of the population, and s the centre of the fine cell at x - c (first step) or x - 2c (second
// step), relative to the centre of the coarse cell X that contains it [coarse cell]:
//
//   coarse to fine   f(x) = f*(X) + sum_a o_a df*/da,     o = s - c/4 (first step), s + c/4 (second step)
//   fine to coarse   F(X) = 1/8 sum of the eight f* that are in X after two steps
//
//   f*       population after collision;  f, F: population before collision
//   df*/da   slope along axis a, from the coarse cells on both sides of X
//
// The offset o is the place at which the coarse population equals the fine one if the flow is linear: there
// f* is the equilibrium at a distance (tau - 1) c upstream, and the two levels have different tau. Across a
// plane interface o is zero along the normal, and its sum over the eight fine cells is zero, so that mass and
// momentum are conserved. At edges of the box the mean of o is subtracted.
//
// No other factor between the non-equilibrium parts of the two levels is needed.
// Rohde, Kandhai, Derksen & van den Akker, Int. J. Numer. Meth. Fluids 51 (2006) 439 (without slopes).

namespace beadswim {

/// Smallest permitted number of coarse cells between the refined cells and the end of the coarse level, or
/// between the refined cells and their periodic image.
constexpr int min_cells_around_level = 3;

/// Exchanges populations between a coarse and a fine level. In each coarse step call, in this order:
///
///   for both fine steps: begin_fine_step(); set_fine_plane() before and read_fine_plane() after each plane
///   of constant z is swept; end_fine_step();
///   then set_coarse_plane() and read_coarse_plane(), likewise, for the coarse level.
///
/// Populations are read right after the sweep, while they are in the cache. They are set for whole planes,
/// because the sweep of a row is slowed down by numbers that have just been stored in its lines of the cache.
/// After the first step, nothing but the sweeps may change the cells at the interface.
class LevelInterface {
 public:
  /// The coordinates of both levels have the same origin. Along each axis the fine level lies inside the
  /// coarse level, or it spans the box and is periodic. Sets `refined` of the coarse level. Throws InputError
  /// if the fine level consists of incomplete coarse cells, or comes closer to the ends of the coarse level
  /// or to its own periodic image than min_cells_around_level. Collective.
  LevelInterface(const Communicator& communicator, Level& coarse, const Level& fine);
  ~LevelInterface();

  /// Exchanges the populations that cross the interface in this fine step. The populations of both levels
  /// must be those after the last collision. Collective.
  void begin_fine_step(const Populations& coarse, const Populations& fine);

  /// Sets the incoming populations of plane z of the fine level's block that come from the coarse level.
  void set_fine_plane(Populations& fine, int z) const;

  /// Reads the populations of plane z of the fine level's block that leave it in the next fine step.
  void read_fine_plane(Populations& fine, int z);

  /// Ends a fine step. Returns true if it was the second one, so that the coarse step is due.
  bool end_fine_step();

  /// Sets the incoming populations of plane z of the coarse level's block that come from the fine level.
  void set_coarse_plane(Populations& coarse, int z) const;

  /// Reads the populations of plane z of the coarse level's block that enter the fine level in the next
  /// coarse step.
  void read_coarse_plane(Populations& coarse, int z);

  /// Returns mass and momentum that have left the fine level in the present coarse step, minus those that
  /// have entered it. The coarse level does not count them yet [fine cell].
  FluidTotals in_transit() const;

  /// Returns the other ranks that exchange populations with this rank.
  std::set<int> neighbours() const;
  /// Returns the messages that have been sent so far.
  const Traffic& traffic() const;

 private:
  struct Lists;
  class Search;
  std::unique_ptr<Lists> lists_;
};

}  // namespace beadswim
