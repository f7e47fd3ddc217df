#include "beadswim/lattice/level_interface.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstdint>
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

/// Calls visit(cell) for all cells of the box [low, high) in its outermost layer along an axis that the fine
/// level does not span.
template <class Visit>
void for_each_outer_cell(const Index3& low, const Index3& high, const std::array<bool, 3>& spans,
                         Visit&& visit) {
  const auto is_outer = [&](int axis, int at) {
    return !spans[axis] && (at == low[axis] || at == high[axis] - 1);
  };
  for (int z = low[2]; z < high[2]; ++z) {
    for (int y = low[1]; y < high[1]; ++y) {
      if (is_outer(2, z) || is_outer(1, y)) {
        for (int x = low[0]; x < high[0]; ++x) visit(Index3(x, y, z));
      } else if (!spans[0]) {
        visit(Index3(low[0], y, z));
        visit(Index3(high[0] - 1, y, z));
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
};
/// Places of the numbers from which a CoarsePopulation is evaluated. Along axes of which no slope is needed,
/// `before` and `after` are -1.
struct CoarseNumbers {
  int centre = 0;
  std::array<int, 3> before{-1, -1, -1}, after{-1, -1, -1};
};

/// Place of a population in a block.
struct PopulationPlace {
  int cell = 0;  ///< index of the cell in Populations
  int direction = 0;
};

/// An incoming population of a fine cell that comes from the coarse level.
struct Entry {
  PopulationPlace place;
  int from = 0;  ///< index of the CoarsePopulation
  std::array<float, 3> offset{};

  double value(const std::vector<CoarsePopulation>& populations) const {
    const CoarsePopulation& p = populations[from];
    return p.value + (offset[0] * p.slope[0] + offset[1] * p.slope[1] + offset[2] * p.slope[2]);
  }
};

/// An outgoing population of a fine cell that leaves the fine level.
struct Departure {
  PopulationPlace place;
  int number = 0;  ///< place in the numbers that are sent
  /// True if the population has only passed an edge of the fine level: it came there as `entry`, and the
  /// coarse level has also moved it to its new coarse cell. Only the change is sent then.
  bool passes = false;
  Entry entry{};
};

/// An incoming population of a coarse cell that comes from the fine level.
struct Arrival {
  PopulationPlace place;
  bool passes = false;         ///< adds to the population that comes from another coarse cell
  std::array<int, 8> parts{};  ///< places of the numbers that are added; -1: none
};

}  // namespace

struct LevelInterface::Lists {
  Lists(const Communicator& communicator, const Level& coarse, const Level& fine)
      : from_coarse(communicator),
        from_fine(communicator),
        entries{ByRow<Entry>(fine.block), ByRow<Entry>(fine.block)},
        arrivals(coarse.block) {}

  NumberExchange from_coarse, from_fine;
  std::vector<PopulationPlace> sent_by_coarse;  ///< in the order of from_coarse.to_send()
  std::vector<CoarseNumbers> numbers;           ///< of coarse_populations
  std::vector<CoarsePopulation> coarse_populations;
  std::array<ByRow<Entry>, 2> entries;               ///< in both fine steps
  std::array<std::vector<Departure>, 2> departures;  ///< in both fine steps
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
    for_each_entry([&](const Index3& cell, int i, int half) {
      Takers& takers = takers_[source_key(cell, i, half)];
      ++takers.count;
      takers.offsets += offset_of(cell, i, half);
    });
    for_each_entry([&](const Index3& cell, int i, int half) {
      const int owner = fine_owner(cell);
      const Entry entry = entry_for(owner, cell, i, half);
      const Index3 local = cell + geometry_.fine.offset - fine_.block.offset;
      if (owner == rank_) lists_.entries[half].row(local[1], local[2]).push_back(entry);
    });
    lists_.coarse_populations.resize(lists_.numbers.size());
  }

  void find_departures() {
    const Index3 low = geometry_.covered.offset - layer(), high = geometry_.covered.end() + layer();
    for_each_outer_cell(low, high, geometry_.spans, [&](const Index3& cell) {
      for (int i = 1; i < d3q19::directions; ++i) find_arrival(cell, i);
    });
  }

 private:
  using Key = std::uint64_t;  ///< identifies a coarse cell and a direction

  /// The parts of a coarse population that enter the fine level.
  struct Takers {
    int count = 0;
    Vec3 offsets = Vec3::Zero();  ///< sum of offset_of()
  };
  /// The numbers that a rank receives from the coarse level.
  struct Received {
    int count = 0;
    std::unordered_map<Key, int> numbers;      ///< place of a population
    std::unordered_map<Key, int> populations;  ///< index in Lists::numbers
  };

  /// Returns one cell along each axis that has an interface.
  Index3 layer() const {
    Index3 cells = Index3::Ones();
    for (int a = 0; a < 3; ++a)
      if (geometry_.spans[a]) cells[a] = 0;
    return cells;
  }
  int fine_owner(const Index3& cell) const {
    return fine_.decomposition.rank_of_cell(cell + geometry_.fine.offset);
  }
  int coarse_owner(const Index3& cell) const { return coarse_.decomposition.rank_of_cell(cell); }

  PopulationPlace fine_place(const Index3& cell, int i) const {
    const Index3 local = cell + geometry_.fine.offset - fine_.block.offset;
    return {.cell = static_cast<int>(fine_.populations.cell(local)), .direction = i};
  }
  PopulationPlace coarse_place(const Index3& cell, int i) const {
    return {.cell = static_cast<int>(coarse_.populations.cell(cell - coarse_.block.offset)), .direction = i};
  }

  Key key_of(const Index3& coarse_cell, int i) const {
    const Index3 p = coarse_cell - geometry_.coarse.offset;
    const Index3& n = geometry_.coarse.size;
    return i + d3q19::directions * (p[0] + static_cast<Key>(n[0]) * (p[1] + static_cast<Key>(n[1]) * p[2]));
  }
  Index3 source_cell(const Index3& cell, int i, int half) const {
    return geometry_.coarse_cell(geometry_.in_fine_period(cell - (1 + half) * velocity_of(i)));
  }
  Key source_key(const Index3& cell, int i, int half) const { return key_of(source_cell(cell, i, half), i); }

  /// Calls visit(fine cell, direction, fine step) for all populations that come from the coarse level.
  template <class Visit>
  void for_each_entry(Visit&& visit) const {
    for_each_outer_cell(Index3::Zero(), geometry_.fine.size, geometry_.spans, [&](const Index3& cell) {
      for (int i = 1; i < d3q19::directions; ++i) {
        if (geometry_.is_fine(geometry_.in_fine_period(cell - velocity_of(i)))) continue;
        for (int half = 0; half < 2; ++half) visit(cell, i, half);
      }
    });
  }

  /// Returns the place of a coarse population in the numbers that a rank receives.
  int number_for(int rank, const Index3& coarse_cell, int i) {
    Received& received = received_[rank];
    const auto [found, is_new] = received.numbers.try_emplace(key_of(coarse_cell, i), received.count);
    if (!is_new) return found->second;
    ++received.count;
    const int owner = coarse_owner(coarse_cell);
    lists_.from_coarse.add(owner, rank);
    if (owner == rank_) lists_.sent_by_coarse.push_back(coarse_place(coarse_cell, i));
    return found->second;
  }

  /// Returns the entry of a fine cell that `owner` owns. Its place is valid on this rank only.
  Entry entry_for(int owner, const Index3& cell, int i, int half) {
    const Index3 source = source_cell(cell, i, half);
    const Takers& takers = takers_.at(key_of(source, i));
    Vec3 offset = offset_of(cell, i, half);
    if (takers.count == 8) offset -= takers.offsets / 8;
    Received& received = received_[owner];
    const auto [found, is_new] =
        received.populations.try_emplace(key_of(source, i), static_cast<int>(received.populations.size()));
    CoarseNumbers unused;
    if (is_new && owner == rank_) lists_.numbers.emplace_back();
    CoarseNumbers& numbers = owner == rank_ ? lists_.numbers[found->second] : unused;
    numbers.centre = number_for(owner, source, i);
    for (int a = 0; a < 3; ++a) {
      const Index3 step(a == 0, a == 1, a == 2);
      const Index3 before = geometry_.in_coarse_period(source - step),
                   after = geometry_.in_coarse_period(source + step);
      if (offset[a] == 0 || geometry_.is_covered(before) || geometry_.is_covered(after)) continue;
      numbers.before[a] = number_for(owner, before, i);
      numbers.after[a] = number_for(owner, after, i);
    }
    Entry entry{.place = {}, .from = found->second};
    if (owner == rank_) entry.place = fine_place(cell, i);
    for (int a = 0; a < 3; ++a) entry.offset[a] = static_cast<float>(offset[a]);
    return entry;
  }

  /// Adds the population of direction i of a coarse cell, if a part of it comes from the fine level.
  void find_arrival(const Index3& cell, int i) {
    const Index3 c = velocity_of(i), owned = geometry_.in_coarse_period(cell);
    const int owner = coarse_owner(owned);
    Arrival arrival{.place = {}, .passes = !geometry_.is_covered(owned - c)};
    bool is_used = false;
    for (int part = 0; part < 8; ++part) {
      const Index3 end = geometry_.first_fine_cell(cell) + Index3(part & 1, part >> 1 & 1, part >> 2);
      const Index3 last = geometry_.in_fine_period(end - c), first = geometry_.in_fine_period(end - 2 * c);
      arrival.parts[part] = -1;
      if (!geometry_.is_fine(last) && !geometry_.is_fine(first)) continue;
      is_used = true;
      const int half = geometry_.is_fine(last) ? 1 : 0;
      const int place = add_departure(half == 1 ? last : first, i, half, arrival.passes, owner);
      if (owner == rank_) arrival.parts[part] = place;
    }
    if (!is_used || owner != rank_) return;
    arrival.place = coarse_place(owned, i);
    const Index3 local = owned - coarse_.block.offset;
    lists_.arrivals.row(local[1], local[2]).push_back(arrival);
  }

  /// Returns the place of the number in those that `to` receives, if this is the present rank.
  int add_departure(const Index3& cell, int i, int half, bool passes, int to) {
    const int from = fine_owner(cell);
    if (from == rank_) {
      Departure departure{.place = fine_place(cell, i),
                          .number = static_cast<int>(lists_.from_fine.to_send().size()),
                          .passes = passes};
      if (passes) departure.entry = entry_for(rank_, cell, i, 0);
      lists_.departures[half].push_back(departure);
    }
    const int place = static_cast<int>(lists_.from_fine.received().size());
    lists_.from_fine.add(from, to);
    return place;
  }

  Lists& lists_;
  const Level& coarse_;
  const Level& fine_;
  Geometry geometry_;
  int rank_;
  std::unordered_map<Key, Takers> takers_;
  std::vector<Received> received_;  ///< by each rank
};

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
    auto number = lists_->from_coarse.to_send().begin();
    for (const PopulationPlace& p : lists_->sent_by_coarse) *number++ = coarse.outgoing(p.direction, p.cell);
    lists_->from_coarse.exchange(lists_->traffic);
    const auto received = lists_->from_coarse.received();
    for (std::size_t n = 0; n < lists_->numbers.size(); ++n) {
      const CoarseNumbers& places = lists_->numbers[n];
      CoarsePopulation& population = lists_->coarse_populations[n];
      population.value = received[places.centre];
      for (int a = 0; a < 3; ++a) {
        if (places.after[a] >= 0)
          population.slope[a] = (received[places.after[a]] - received[places.before[a]]) / 2;
      }
    }
  }
  const auto to_send = lists_->from_fine.to_send();
  for (const Departure& departure : lists_->departures[lists_->half]) {
    double& number = to_send[departure.number];
    number = fine.outgoing(departure.place.direction, departure.place.cell);
    if (departure.passes) number -= departure.entry.value(lists_->coarse_populations);
  }
}

void LevelInterface::set_fine_row(Populations& fine, int y, int z) const {
  for (const Entry& entry : lists_->entries[lists_->half].row(y, z))
    fine.set_incoming(entry.place.direction, entry.place.cell, entry.value(lists_->coarse_populations));
}

bool LevelInterface::end_fine_step() {
  lists_->half = 1 - lists_->half;
  if (lists_->half == 1) return false;
  lists_->from_fine.exchange(lists_->traffic);
  return true;
}

void LevelInterface::set_coarse_row(Populations& coarse, int y, int z) const {
  const auto received = lists_->from_fine.received();
  for (const Arrival& arrival : lists_->arrivals.row(y, z)) {
    const auto [cell, direction] = arrival.place;
    double sum = 0;
    for (const int part : arrival.parts)
      if (part >= 0) sum += received[part];
    const double passing = arrival.passes ? coarse.incoming(direction, cell) : 0;
    coarse.set_incoming(direction, cell, passing + sum / 8);
  }
}

FluidTotals LevelInterface::in_transit() const {
  FluidTotals totals;
  if (lists_->half == 0) return totals;
  const auto add = [&](int direction, double population) {
    totals.add({.density_deviation = population,
                .momentum = population * velocity_of(direction).cast<double>().matrix()});
  };
  const auto sent = lists_->from_fine.to_send();
  for (const Departure& departure : lists_->departures[0])
    add(departure.place.direction, sent[departure.number]);
  for (const auto& row : lists_->entries[0].rows())
    for (const Entry& entry : row) add(entry.place.direction, -entry.value(lists_->coarse_populations));
  return totals;
}

bool LevelInterface::is_within_step() const {
  return lists_->half == 1;
}

const Traffic& LevelInterface::traffic() const {
  return lists_->traffic;
}

}  // namespace beadswim
