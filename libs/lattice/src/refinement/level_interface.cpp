#include "beadswim/lattice/level_interface.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <unordered_map>
#include <vector>

#include "beadswim/core/error.hpp"
#include "number_exchange.hpp"

namespace beadswim {
namespace {

int modulo(int n, int period) {
  const int rest = n % period;
  return rest < 0 ? rest + period : rest;
}
Index3 velocity_of(int i) {
  return {d3q19::velocity[i][0], d3q19::velocity[i][1], d3q19::velocity[i][2]};
}

/// Positions of the two levels. Coarse cells have coordinates of the coarse level, fine cells have
/// coordinates relative to the first cell of the fine level.
struct Geometry {
  Block coarse, fine, covered;  ///< covered: cells of the coarse level under the fine level
  std::array<bool, 3> wraps{};  ///< the coarse level is periodic along the axis
  std::array<bool, 3> spans{};  ///< the fine level is periodic along the axis: no interface

  Geometry(const LevelPlace& coarse_place, const LevelPlace& fine_place)
      : coarse(coarse_place.lattice), fine(fine_place.lattice) {
    for (int a = 0; a < 3; ++a) {
      wraps[a] = coarse_place.is_periodic(a);
      spans[a] = fine_place.is_periodic(a);
    }
    covered = fine.halved();
  }

  Index3 in_fine_period(Index3 cell) const {
    for (int a = 0; a < 3; ++a)
      if (spans[a]) cell[a] = modulo(cell[a], fine.size[a]);
    return cell;
  }
  bool is_fine(const Index3& cell) const { return (cell >= 0).all() && (cell < fine.size).all(); }

  Index3 in_coarse_period(Index3 cell) const {
    for (int a = 0; a < 3; ++a)
      if (wraps[a]) cell[a] = coarse.offset[a] + modulo(cell[a] - coarse.offset[a], coarse.size[a]);
    return cell;
  }
  bool is_covered(const Index3& cell) const {
    for (int a = 0; a < 3; ++a) {
      int place = cell[a] - covered.offset[a];
      if (wraps[a]) place = modulo(place, coarse.size[a]);
      if (place < 0 || place >= covered.size[a]) return false;
    }
    return true;
  }
  /// Returns the coarse cell that contains a fine cell, which may lie outside the fine level.
  Index3 coarse_cell(const Index3& cell) const {
    return in_coarse_period((cell + fine.offset).unaryExpr(&Block::floor_half));
  }
  /// Throws InputError if the fine level has a size or place that the interface does not permit.
  void check() const {
    for (int a = 0; a < 3; ++a) {
      const int low = covered.offset[a] - coarse.offset[a], high = coarse.end()[a] - covered.end()[a];
      const bool is_whole = fine.offset[a] % 2 == 0 && fine.size[a] % 2 == 0;
      const bool has_room = wraps[a] ? coarse.size[a] - covered.size[a] >= min_cells_around_level
                                     : std::min(low, high) >= min_cells_around_level;
      if (is_whole && (spans[a] || (has_room && covered.size[a] >= 2))) continue;
      throw InputError(fmt::format(
          "a level of {} cells from cell {} on along {} does not fit into a level of {} coarser cells from "
          "cell "
          "{} on: it needs whole coarse cells, at least two of them, and {} coarser cells around them",
          fine.size[a], fine.offset[a], "xyz"[a], coarse.size[a], coarse.offset[a], min_cells_around_level));
    }
  }

  /// Returns the first of the eight fine cells in a coarse cell.
  Index3 first_fine_cell(const Index3& coarse_cell) const { return 2 * coarse_cell - fine.offset; }
};

/// Returns the offset o at which a coarse population has the value that the fine cell receives along
/// direction i in fine step `half` (0 or 1) [coarse cell].
Vec3 offset_of(const Index3& cell, int i, int half) {
  const Index3 from = cell - (1 + half) * velocity_of(i);
  const Index3 side = from.unaryExpr([](int n) { return modulo(n, 2) == 0 ? -1 : 1; });
  return ((side + (half == 0 ? -1 : 1) * velocity_of(i)).cast<double>() / 4).matrix();
}

/// Calls visit(first cell, number of cells) for all runs of cells along x in the outermost layer of a box of
/// `size` cells, along axes that the fine level does not span.
template <class Visit>
void for_each_outer_run(const Index3& size, const std::array<bool, 3>& spans, Visit&& visit) {
  const auto is_outer = [&](int axis, int at) { return !spans[axis] && (at == 0 || at == size[axis] - 1); };
  for (int z = 0; z < size[2]; ++z) {
    for (int y = 0; y < size[1]; ++y) {
      if (is_outer(2, z) || is_outer(1, y)) {
        visit(Index3(0, y, z), size[0]);
      } else if (!spans[0]) {
        visit(Index3(0, y, z), 1);
        visit(Index3(size[0] - 1, y, z), 1);
      }
    }
  }
}

/// Lists of T, one for each row of a block.
template <class T>
class ByRow {
 public:
  explicit ByRow(const Block& block) : rows_in_plane_(block.size[1]), rows_(block.size[1] * block.size[2]) {}

  std::vector<T>& row(int y, int z) { return rows_[y + rows_in_plane_ * z]; }
  const std::vector<std::vector<T>>& rows() const { return rows_; }
  const std::vector<T>& row(int y, int z) const { return rows_[y + rows_in_plane_ * z]; }

 private:
  std::ptrdiff_t rows_in_plane_;
  std::vector<std::vector<T>> rows_;
};

/// A population that a coarse cell sends to the fine level.
struct CoarsePopulation {
  double value = 0;
  Vec3 slope = Vec3::Zero();  ///< [1/coarse cell]

  /// Evaluates the population at an offset from the centre of its cell [coarse cell].
  double at(const Vec3& offset) const {
    return value + (offset[0] * slope[0] + offset[1] * slope[1] + offset[2] * slope[2]);
  }
};
/// Places of the numbers from which a CoarsePopulation is evaluated. Along axes of which no slope is needed,
/// `before` and `after` are -1.
struct CoarseNumbers {
  int centre = -1;
  std::array<int, 3> before{-1, -1, -1}, after{-1, -1, -1};
};

/// An incoming population of a fine cell that comes from the coarse level.
struct Entry {
  int from = 0;             ///< index of the CoarsePopulation
  std::uint8_t offset = 0;  ///< index in Lists::offsets
};
/// Entries of one direction in consecutive cells along x. From cell to cell, the offsets alternate, and the
/// coarse population is the same or the next one, in turn.
struct EntryRun {
  int first = 0;  ///< index of the first cell in Populations
  int cells = 0;
  int from = 0;  ///< index of the CoarsePopulation of the first cell
  std::uint8_t direction = 0;
  std::uint8_t in_first = 1;              ///< number of cells with the first population, 1 or 2
  std::array<std::uint8_t, 2> offsets{};  ///< of the first and of the second cell

  /// Returns true if `entry` belongs to the cell after the last one.
  bool is_followed_by(const Entry& entry) const {
    if (cells == 1) return entry.from == from || entry.from == from + 1;
    return entry.from == from + (cells + 2 - in_first) / 2 && entry.offset == offsets[cells % 2];
  }
  void append(const Entry& entry) {
    if (cells == 1) {
      in_first = entry.from == from ? 2 : 1;
      offsets[1] = entry.offset;
    }
    ++cells;
  }
};

/// Outgoing populations that are sent to the other level.
struct DepartureRun {
  int first = 0;  ///< index of the first cell in Populations; the others follow along x
  int cells = 0;
  int direction = 0;
  int number = 0;  ///< place of the first one in the NumberExchange; the others follow
};

/// A population of a fine cell that leaves the fine level after it has only passed an edge of it: it came
/// there as `entry`, and the coarse level has also moved it to its new coarse cell. Only the change is sent.
struct Passing {
  int number = 0;  ///< place in the NumberExchange
  Entry entry;
};

/// An incoming population of a coarse cell that comes from the fine level.
struct Arrival {
  int cell = 0, direction = 0;
  bool passes = false;  ///< adds to the population that comes from another coarse cell
  std::array<int, 8> parts{-1, -1, -1, -1, -1, -1, -1, -1};  ///< places of the numbers that are added
};

}  // namespace

struct LevelInterface::Lists {
  Lists(const Communicator& communicator, const Level& coarse, const Level& fine)
      : from_coarse(communicator),
        from_fine(communicator),
        entries{ByRow<EntryRun>(fine.block), ByRow<EntryRun>(fine.block)},
        arrivals(coarse.block) {}

  NumberExchange from_coarse, from_fine;
  std::vector<DepartureRun> sent_by_coarse;
  std::vector<CoarseNumbers> numbers;  ///< of coarse_populations
  std::vector<CoarsePopulation> coarse_populations;
  std::vector<Vec3> offsets;                            ///< all offsets that entries have [coarse cell]
  std::array<ByRow<EntryRun>, 2> entries;               ///< in both fine steps
  std::array<std::vector<DepartureRun>, 2> departures;  ///< in both fine steps
  std::vector<Passing> passing;                         ///< in the second fine step
  ByRow<Arrival> arrivals;
  int half = 0;  ///< number of fine steps done in this coarse step
  Traffic traffic;
};

/// Fills the lists. All ranks visit the populations that cross the interface in the same order.
class LevelInterface::Search {
 public:
  Search(Lists& lists, const Level& coarse, const Level& fine, const Communicator& communicator)
      : lists_(lists),
        coarse_(coarse),
        fine_(fine),
        geometry_(coarse.place, fine.place),
        rank_(communicator.rank()),
        received_(communicator.size()) {}

  void find_entries() {
    std::vector<std::map<Key, Source>> sources(received_.size());  // of each rank, in the order of the keys
    for_each_entry([&](const Index3& cell, int i, int half) {
      const Source source{.cell = source_cell(cell, i, half), .direction = i};
      Takers& takers = takers_[source.key(geometry_)];
      ++takers.count;
      takers.offsets += offset_of(cell, i, half);
      sources[fine_owner(cell)].emplace(source.key(geometry_), source);
    });
    for (std::size_t rank = 0; rank < sources.size(); ++rank)
      for (const auto& [key, source] : sources[rank]) add_source(static_cast<int>(rank), key, source);
    for_each_entry([&](const Index3& cell, int i, int half) {
      if (fine_owner(cell) == rank_) add_entry(cell, i, half);
    });
    lists_.coarse_populations.resize(lists_.numbers.size());
  }

  void find_departures() {
    std::map<Key, Arrival> arrivals;
    for_each_crossing(1, [&](const Index3& cell, int i) {
      for (int half = 0; half < 2; ++half) add_departure(cell, i, half, arrivals);
    });
    for (const auto& [key, arrival] : arrivals) {
      const auto in_block = arrival.cell - coarse_.populations.cell(0, 0, 0);
      const auto z = in_block / coarse_.populations.pitch(2);
      const auto y = (in_block - z * coarse_.populations.pitch(2)) / coarse_.populations.pitch(1);
      lists_.arrivals.row(static_cast<int>(y), static_cast<int>(z)).push_back(arrival);
    }
  }

 private:
  using Key = std::uint64_t;  ///< identifies a coarse cell and a direction

  /// The parts of a coarse population that enter the fine level.
  struct Takers {
    int count = 0;
    Vec3 offsets = Vec3::Zero();  ///< sum of offset_of()
  };
  /// A population of a coarse cell.
  struct Source {
    Index3 cell = Index3::Zero();
    int direction = 0;

    /// Keys of one direction and row follow one another along x.
    Key key(const Geometry& geometry) const {
      const Index3 p = cell - geometry.coarse.offset;
      const Index3& n = geometry.coarse.size;
      return p[0] + static_cast<Key>(n[0]) *
                        (p[1] + static_cast<Key>(n[1]) * (p[2] + static_cast<Key>(n[2]) * direction));
    }
  };
  /// What a rank receives from the coarse level.
  struct Received {
    std::unordered_map<Key, int> numbers;      ///< place of a population in Lists::from_coarse
    std::unordered_map<Key, int> populations;  ///< index in Lists::numbers
  };

  int fine_owner(const Index3& cell) const {
    return fine_.decomposition.rank_of_cell(cell + geometry_.fine.offset);
  }
  int coarse_owner(const Index3& cell) const { return coarse_.decomposition.rank_of_cell(cell); }

  int fine_index(const Index3& cell) const {
    return static_cast<int>(fine_.populations.cell(cell + geometry_.fine.offset - fine_.block.offset));
  }
  int coarse_index(const Index3& cell) const {
    return static_cast<int>(coarse_.populations.cell(cell - coarse_.block.offset));
  }
  Index3 source_cell(const Index3& cell, int i, int half) const {
    return geometry_.coarse_cell(geometry_.in_fine_period(cell - (1 + half) * velocity_of(i)));
  }

  /// Calls visit(fine cell, direction i) for all links of the fine level along `sign` times the velocity of i
  /// that cross the interface, in runs of cells along x.
  template <class Visit>
  void for_each_crossing(int sign, Visit&& visit) const {
    for_each_outer_run(geometry_.fine.size, geometry_.spans, [&](const Index3& first, int cells) {
      for (int i = 1; i < d3q19::directions; ++i) {
        for (int n = 0; n < cells; ++n) {
          const Index3 cell = first + Index3(n, 0, 0);
          if (!geometry_.is_fine(geometry_.in_fine_period(cell + sign * velocity_of(i)))) visit(cell, i);
        }
      }
    });
  }
  /// Calls visit(fine cell, direction, fine step) for all populations that come from the coarse level.
  template <class Visit>
  void for_each_entry(Visit&& visit) const {
    for (int half = 0; half < 2; ++half)
      for_each_crossing(-1, [&](const Index3& cell, int i) { visit(cell, i, half); });
  }

  /// Returns the place of a coarse population that `rank` receives, if this is the present rank.
  int number_for(int rank, const Source& source) {
    const auto [found, is_new] = received_[rank].numbers.try_emplace(source.key(geometry_), -1);
    if (!is_new) return found->second;
    const int owner = coarse_owner(source.cell);
    found->second = lists_.from_coarse.add(owner, rank);
    if (owner == rank_)
      add_to_runs(lists_.sent_by_coarse, source.direction, coarse_index(source.cell), found->second);
    return found->second;
  }

  /// Adds the numbers that `rank` needs for a coarse population.
  void add_source(int rank, Key key, const Source& source) {
    CoarseNumbers numbers;
    numbers.centre = number_for(rank, source);
    for (int a = 0; a < 3; ++a) {
      const Index3 step(a == 0, a == 1, a == 2);
      const Source before{.cell = geometry_.in_coarse_period(source.cell - step),
                          .direction = source.direction};
      const Source after{.cell = geometry_.in_coarse_period(source.cell + step),
                         .direction = source.direction};
      if (geometry_.is_covered(before.cell) || geometry_.is_covered(after.cell)) continue;
      numbers.before[a] = number_for(rank, before);
      numbers.after[a] = number_for(rank, after);
    }
    if (rank != rank_) return;
    received_[rank].populations[key] = static_cast<int>(lists_.numbers.size());
    lists_.numbers.push_back(numbers);
  }

  std::uint8_t offset_index(const Vec3& offset) {
    const auto found = std::ranges::find(lists_.offsets, offset);
    const auto index = static_cast<std::uint8_t>(found - lists_.offsets.begin());
    if (found == lists_.offsets.end()) lists_.offsets.push_back(offset);
    return index;
  }

  /// Returns the entry of a fine cell of this rank.
  Entry entry_of(const Index3& cell, int i, int half) {
    const Key key = Source{.cell = source_cell(cell, i, half), .direction = i}.key(geometry_);
    const Takers& takers = takers_.at(key);
    Vec3 offset = offset_of(cell, i, half);
    if (takers.count == 8) offset -= takers.offsets / 8;
    return {.from = received_[rank_].populations.at(key), .offset = offset_index(offset)};
  }

  void add_entry(const Index3& cell, int i, int half) {
    const Index3 local = cell + geometry_.fine.offset - fine_.block.offset;
    std::vector<EntryRun>& runs = lists_.entries[half].row(local[1], local[2]);
    const Entry entry = entry_of(cell, i, half);
    const int index = fine_index(cell);
    if (!runs.empty()) {
      EntryRun& last = runs.back();
      const bool is_next = last.direction == i && last.first + last.cells == index;
      if (is_next && last.is_followed_by(entry)) return last.append(entry);
    }
    runs.push_back({.first = index,
                    .cells = 1,
                    .from = entry.from,
                    .direction = static_cast<std::uint8_t>(i),
                    .offsets = {entry.offset, entry.offset}});
  }

  static void add_to_runs(std::vector<DepartureRun>& runs, int i, int index, int number) {
    if (!runs.empty()) {
      DepartureRun& last = runs.back();
      if (last.direction == i && last.first + last.cells == index && last.number + last.cells == number) {
        ++last.cells;
        return;
      }
    }
    runs.push_back({.first = index, .cells = 1, .direction = i, .number = number});
  }

  /// Adds the population of direction i that leaves a fine cell in fine step `half`, and its arrival.
  void add_departure(const Index3& cell, int i, int half, std::map<Key, Arrival>& arrivals) {
    const Index3 end = cell + (2 - half) * velocity_of(i);  // fine cell in which it is after the second step
    const Source target{.cell = geometry_.coarse_cell(geometry_.in_fine_period(end)), .direction = i};
    const bool passes = !geometry_.is_covered(target.cell - velocity_of(i));
    const int from = fine_owner(cell), to = coarse_owner(target.cell);
    const int number = lists_.from_fine.add(from, to);
    if (from == rank_) {
      add_to_runs(lists_.departures[half], i, fine_index(cell), number);
      if (passes) lists_.passing.push_back({.number = number, .entry = entry_of(cell, i, 0)});
    }
    if (to != rank_) return;
    Arrival& arrival = arrivals[target.key(geometry_)];
    arrival.cell = coarse_index(target.cell);
    arrival.direction = i;
    arrival.passes = passes;
    const Index3 side = end.unaryExpr([](int n) { return modulo(n, 2); });
    arrival.parts[side[0] + 2 * side[1] + 4 * side[2]] = number;
  }

  Lists& lists_;
  const Level& coarse_;
  const Level& fine_;
  Geometry geometry_;
  int rank_;
  std::unordered_map<Key, Takers> takers_;
  std::vector<Received> received_;  ///< by each rank
};

namespace {

/// Reads outgoing populations into the numbers of an exchange. Runs along the faces across x are single cells
/// in different rows, which are prefetched.
void read(const Populations& populations, const std::vector<DepartureRun>& departures,
          NumberExchange& numbers) {
  constexpr std::size_t runs_ahead = 32;
  in_precision(populations.precision(), [&]<class Real>() {
    for (std::size_t k = 0; k < departures.size(); ++k) {
      if (k + runs_ahead < departures.size()) {
        const DepartureRun& later = departures[k + runs_ahead];
        __builtin_prefetch(populations.outgoing_row<Real>(later.direction, later.first));
      }
      const DepartureRun& run = departures[k];
      const Real* from = populations.outgoing_row<Real>(run.direction, run.first);
      double* to = &numbers[run.number];
      for (int n = 0; n < run.cells; ++n) to[n] = static_cast<double>(from[n]);
    }
  });
}

/// Sets the incoming populations of a run of fine cells.
template <class Real>
void set_run(const EntryRun& run, const std::vector<Vec3>& offsets,
             const std::vector<CoarsePopulation>& populations, Real* to) {
  const CoarsePopulation* from = &populations[run.from];
  int n = 0;
  if (run.in_first == 1) to[n++] = static_cast<Real>((from++)->at(offsets[run.offsets[0]]));
  const Vec3 one = offsets[run.offsets[n % 2]], other = offsets[run.offsets[(n + 1) % 2]];
  for (; n + 1 < run.cells; n += 2, ++from) {
    to[n] = static_cast<Real>(from->at(one));
    to[n + 1] = static_cast<Real>(from->at(other));
  }
  if (n < run.cells) to[n] = static_cast<Real>(from->at(one));
}

/// Evaluates values and slopes of populations of coarse cells.
void evaluate(const std::vector<CoarseNumbers>& places, const NumberExchange& numbers,
              std::vector<CoarsePopulation>& populations) {
  for (std::size_t n = 0; n < places.size(); ++n) {
    const CoarseNumbers& from = places[n];
    populations[n].value = numbers[from.centre];
    for (int a = 0; a < 3; ++a) {
      if (from.after[a] >= 0)
        populations[n].slope[a] = (numbers[from.after[a]] - numbers[from.before[a]]) / 2;
    }
  }
}

}  // namespace

LevelInterface::LevelInterface(const Communicator& communicator, Level& coarse, const Level& fine)
    : lists_(std::make_unique<Lists>(communicator, coarse, fine)) {
  const Geometry geometry(coarse.place, fine.place);
  geometry.check();
  coarse.covered = coarse.place.parts_under(fine.place, coarse.block);
  std::erase_if(coarse.covered, [](const Block& part) { return part.is_empty(); });
  Search search(*lists_, coarse, fine, communicator);
  search.find_entries();
  search.find_departures();
}

LevelInterface::~LevelInterface() = default;

void LevelInterface::begin_fine_step(const Populations& coarse, const Populations& fine) {
  if (lists_->half == 0) {
    read(coarse, lists_->sent_by_coarse, lists_->from_coarse);
    lists_->from_coarse.exchange(lists_->traffic);
    evaluate(lists_->numbers, lists_->from_coarse, lists_->coarse_populations);
  }
  read(fine, lists_->departures[lists_->half], lists_->from_fine);
}

void LevelInterface::set_fine_row(Populations& fine, int y, int z) const {
  in_precision(fine.precision(), [&]<class Real>() {
    for (const EntryRun& run : lists_->entries[lists_->half].row(y, z))
      set_run(run, lists_->offsets, lists_->coarse_populations,
              fine.incoming_row<Real>(run.direction, run.first));
  });
}

bool LevelInterface::end_fine_step() {
  lists_->half = 1 - lists_->half;
  if (lists_->half == 1) return false;
  for (const Passing& passing : lists_->passing)
    lists_->from_fine[passing.number] -=
        lists_->coarse_populations[passing.entry.from].at(lists_->offsets[passing.entry.offset]);
  lists_->from_fine.exchange(lists_->traffic);
  return true;
}

void LevelInterface::set_coarse_row(Populations& coarse, int y, int z) const {
  in_precision(coarse.precision(), [&]<class Real>() {
    for (const Arrival& arrival : lists_->arrivals.row(y, z)) {
      double sum = 0;
      for (const int part : arrival.parts)
        if (part >= 0) sum += lists_->from_fine[part];
      Real& incoming = *coarse.incoming_row<Real>(arrival.direction, arrival.cell);
      const double passing = arrival.passes ? static_cast<double>(incoming) : 0;
      incoming = static_cast<Real>(passing + sum / 8);
    }
  });
}

FluidTotals LevelInterface::in_transit() const {
  FluidTotals totals;
  if (lists_->half == 0) return totals;
  const auto add = [&](int direction, double population) {
    totals.add({.density_deviation = population,
                .momentum = population * velocity_of(direction).cast<double>().matrix()});
  };
  for (const DepartureRun& run : lists_->departures[0])
    for (int n = 0; n < run.cells; ++n) add(run.direction, lists_->from_fine[run.number + n]);
  std::vector<double> entered;
  for (const auto& row : lists_->entries[0].rows()) {
    for (const EntryRun& run : row) {
      entered.resize(run.cells);
      set_run(run, lists_->offsets, lists_->coarse_populations, entered.data());
      for (const double population : entered) add(run.direction, -population);
    }
  }
  return totals;
}

std::set<int> LevelInterface::neighbours() const {
  std::set<int> others = lists_->from_coarse.peers();
  others.merge(lists_->from_fine.peers());
  return others;
}

bool LevelInterface::is_within_step() const {
  return lists_->half == 1;
}

const Traffic& LevelInterface::traffic() const {
  return lists_->traffic;
}

}  // namespace beadswim
