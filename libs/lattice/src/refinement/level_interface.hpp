#pragma once

#include <algorithm>
#include <array>
#include <iterator>
#include <set>
#include <vector>

#include "beadswim/lattice/levels.hpp"
#include "number_exchange.hpp"
#include "populations_by_row.hpp"

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

/// A population that a coarse cell sends to the fine level.
struct CoarsePopulation {
  double value = 0;
  Vec3 slope = Vec3::Zero();  ///< [1/coarse cell]

  /// Evaluates the population at an offset from the centre of its cell [coarse cell].
  double at(const Vec3& offset) const {
    return value + (offset[0] * slope[0] + offset[1] * slope[1] + offset[2] * slope[2]);
  }
};
/// Places of the numbers from which a CoarsePopulation is evaluated. Along axes without a slope, `before` and
/// `after` are equal.
struct CoarseNumbers {
  int centre = 0;
  std::array<int, 3> before{}, after{};
};

/// A population that enters a fine cell.
struct Entry {
  int from = 0;    ///< index of the CoarsePopulation
  int offset = 0;  ///< index in LevelInterface::offsets_
};

/// A population that enters the fine level in the first fine step, as `entry`, and leaves it in the second
/// one, at an edge of the fine level. The coarse level also moves this population from one coarse cell to
/// another. The fine level therefore sends only the change of the population.
struct EdgePassage {
  int number = 0;  ///< place in the NumberExchange of the second fine step
  Entry entry;
};

/// Sums of the numbers that arrive in coarse cells, in the order of LevelInterface::arrivals_.
class ArrivingSums {
 public:
  /// Adds a sum of the numbers at `places`, as [fine step].
  void add(const std::array<std::vector<int>, 2>& places) {
    for (int half = 0; half < 2; ++half) {
      std::ranges::copy(places[half], std::back_inserter(parts_[half].places));
      parts_[half].ends.push_back(static_cast<int>(parts_[half].places.size()));
    }
    sums_.push_back(0);
  }

  /// Adds the numbers of a fine step. Those of the first one replace the sums.
  void receive(int half, const NumberExchange& numbers) {
    const int* place = parts_[half].places.data();
    for (std::size_t n = 0; n < sums_.size(); ++n) {
      double sum = half == 0 ? 0 : sums_[n];
      for (const int* end = parts_[half].places.data() + parts_[half].ends[n]; place != end; ++place)
        sum += numbers[*place];
      sums_[n] = sum;
    }
  }
  const std::vector<double>& sums() const { return sums_; }

 private:
  /// Places of the numbers of all sums, one sum after another.
  struct Parts {
    std::vector<int> places;
    std::vector<int> ends;  ///< one per sum: index in `places` after its last number
  };
  std::array<Parts, 2> parts_;  ///< one per fine step
  std::vector<double> sums_;
};

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
  const Traffic& traffic() const { return traffic_; }

 private:
  class Search;

  NumberExchange from_coarse_;               ///< own numbers: sent_by_coarse_
  std::array<NumberExchange, 2> from_fine_;  ///< one per fine step; own numbers: departures_
  PopulationsByRow sent_by_coarse_;          ///< outgoing populations of coarse cells
  PopulationsByRow entries_, departures_;    ///< incoming and outgoing populations of fine cells
  PopulationsByRow arrivals_;                ///< incoming populations of coarse cells
  PopulationsByRow passing_arrivals_;        ///< arrivals that add to the population from another coarse cell
  std::vector<CoarseNumbers> numbers_;       ///< sources of coarse_populations_
  std::vector<CoarsePopulation> coarse_populations_;
  std::vector<Vec3> offsets_;                      ///< all offsets that entries have [coarse cell]
  std::array<std::vector<Entry>, 2> entry_lists_;  ///< one per fine step, in the order of `entries_`
  std::vector<double> entering_;                   ///< values of `entries_` in the present fine step
  std::vector<EdgePassage> edge_passages_;
  ArrivingSums arriving_, arriving_passing_;
  int half_ = 0;              ///< number of fine steps done in this coarse step
  bool has_numbers_ = false;  ///< the numbers of the next fine step have been read
  Traffic traffic_;
};

}  // namespace beadswim
