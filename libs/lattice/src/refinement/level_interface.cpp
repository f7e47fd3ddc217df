#include "level_interface.hpp"

#include <fmt/core.h>

#include <cstdint>
#include <map>
#include <unordered_map>

#include "beadswim/core/error.hpp"

namespace beadswim {
namespace {

/// Throws InputError if a fine level has a size or place that its interface with the coarse level does not
/// permit.
void require_room(const LevelPlace& coarse, const LevelPlace& fine) {
  const Block refined = fine.lattice.halved();
  for (int a = 0; a < 3; ++a) {
    const int low = refined.offset[a] - coarse.lattice.offset[a],
              high = coarse.lattice.end()[a] - refined.end()[a];
    const bool is_whole = fine.lattice.offset[a] % 2 == 0 && fine.lattice.size[a] % 2 == 0;
    const bool has_room = coarse.is_periodic(a) ? coarse.box[a] - refined.size[a] >= min_cells_around_level
                                                : std::min(low, high) >= min_cells_around_level;
    if (is_whole && (fine.is_periodic(a) || (has_room && refined.size[a] >= 2))) continue;
    throw InputError(fmt::format(
        "a level of {} cells from cell {} on along {} does not fit into a level of {} coarser cells from "
        "cell {} on: it needs whole coarse cells, at least two of them, and {} coarser cells around them",
        fine.lattice.size[a], fine.lattice.offset[a], "xyz"[a], coarse.lattice.size[a],
        coarse.lattice.offset[a], min_cells_around_level));
  }
}

/// Returns 0 or 1 along each axis: the position of a fine cell within its coarse cell.
Index3 side_in_coarse_cell(const Index3& cell) {
  return cell - 2 * cell.unaryExpr(&Block::floor_half);
}

/// Returns the offset o at which a coarse population has the value that the fine cell receives along
/// direction i in fine step `half` (0 or 1) [coarse cell].
Vec3 offset_of(const Index3& cell, int i, int half) {
  const Index3 side = 2 * side_in_coarse_cell(cell - (1 + half) * lattice_vector(i)) - 1;  // -1 or 1
  return ((side + (half == 0 ? -1 : 1) * lattice_vector(i)).cast<double>() / 4).matrix();
}

/// Calls visit(first cell, number of cells) for all runs of cells along x in the outermost layer of a level,
/// along axes where the level is not periodic.
template <class Visit>
void for_each_outer_run(const LevelPlace& place, Visit&& visit) {
  const Index3 low = place.lattice.offset, last = place.lattice.end() - 1;
  const auto is_outer = [&](int axis, int at) {
    return !place.is_periodic(axis) && (at == low[axis] || at == last[axis]);
  };
  for (int z = low[2]; z <= last[2]; ++z) {
    for (int y = low[1]; y <= last[1]; ++y) {
      if (is_outer(2, z) || is_outer(1, y)) {
        visit(Index3(low[0], y, z), place.lattice.size[0]);
      } else if (!place.is_periodic(0)) {
        visit(Index3(low[0], y, z), 1);
        visit(Index3(last[0], y, z), 1);
      }
    }
  }
}

}  // namespace

/// Fills the lists. Each rank asks the owners of cells for the populations that it needs.
class LevelInterface::Search {
 public:
  Search(LevelInterface& to_fill, const Level& coarse, const Level& fine, const Communicator& communicator)
      : interface_(to_fill), coarse_(coarse), fine_(fine), communicator_(communicator) {}

  void find_entries() {
    Wanted sources, wanted;  // wanted: also the neighbours of the sources, for slopes
    std::vector<CellPopulation> entries;
    for_each_entry([&](const Index3& cell, int i, int half) {
      const CellPopulation source = source_of(cell, i, half);
      EnteringParts& parts = entering_parts_[key_of(coarse_, source)];
      ++parts.count;
      parts.offsets += offset_of(cell, i, half);
      if (!is_own(fine_, cell)) return;
      sources.emplace(key_of(coarse_, source), source);
      if (half == 0) entries.push_back({.cell = cell, .direction = i});
    });
    interface_.entries_ = PopulationsByRow(fine_.block, entries);
    interface_.entering_.resize(entries.size());
    for (const auto& [key, source] : sources) {
      wanted.emplace(key, source);
      for_each_slope(source, [&](int, const CellPopulation& before, const CellPopulation& after) {
        wanted.emplace(key_of(coarse_, before), before);
        wanted.emplace(key_of(coarse_, after), after);
      });
    }
    const Places places = request(coarse_, wanted, interface_.sent_by_coarse_, interface_.from_coarse_);
    for (const auto& [key, source] : sources) add_source(key, source, places);
    interface_.coarse_populations_.resize(interface_.numbers_.size());
    for_each_entry([&](const Index3& cell, int i, int half) {
      if (is_own(fine_, cell)) interface_.entry_lists_[half].push_back(entry_of(cell, i, half));
    });
  }

  void find_departures() {
    std::array<Places, 2> places;  // of the departures that arrive in this rank, by fine step
    for (int half = 0; half < 2; ++half) {
      Wanted wanted;
      for_each_crossing(1, [&](const Index3& cell, int i) {
        const CellPopulation departure{.cell = cell, .direction = i};
        if (is_own(coarse_, target_cell(cell, i, half))) wanted.emplace(key_of(fine_, departure), departure);
      });
      places[half] = request(fine_, wanted, interface_.departures_, interface_.from_fine_[half]);
    }
    std::map<Key, Target> targets;
    for_each_crossing(1, [&](const Index3& cell, int i) {
      for (int half = 0; half < 2; ++half) add_departure(cell, i, half, places[half], targets);
    });
    std::vector<CellPopulation> arrivals, passing;
    for (const auto& [key, target] : targets) {
      (target.passes ? passing : arrivals).push_back(target.population);
      (target.passes ? interface_.arriving_passing_ : interface_.arriving_).add(target.places);
    }
    interface_.arrivals_ = PopulationsByRow(coarse_.block, arrivals);
    interface_.passing_arrivals_ = PopulationsByRow(coarse_.block, passing);
  }

 private:
  using Key = std::uint64_t;  ///< identifies a cell and a direction
  using Wanted = std::map<Key, CellPopulation>;
  using Places = std::unordered_map<Key, int>;  ///< in a NumberExchange

  /// The parts of a coarse population that enter the fine level.
  struct EnteringParts {
    int count = 0;
    Vec3 offsets = Vec3::Zero();  ///< sum of offset_of()
  };
  /// A population of a coarse cell of this rank that comes from the fine level.
  struct Target {
    CellPopulation population;
    bool passes = false;                     ///< belongs to LevelInterface::passing_arrivals_
    std::array<std::vector<int>, 2> places;  ///< of the numbers that are added, as [fine step]
  };

  /// Returns a number that sorts populations of a level by row, then by direction, then by x.
  static Key key_of(const Level& level, const CellPopulation& population) {
    const Index3 p = population.cell - level.place.lattice.offset;
    const Index3& n = level.place.lattice.size;
    return p[0] + static_cast<Key>(n[0]) *
                      (population.direction + d3q19::directions * (p[1] + static_cast<Key>(n[1]) * p[2]));
  }

  static bool is_own(const Level& level, const Index3& cell) { return level.block.contains(cell); }

  bool is_refined(const Index3& coarse_cell) const { return fine_.place.contains(2 * coarse_cell); }
  /// Returns the coarse cell that contains a fine cell, which may lie outside the fine level.
  Index3 coarse_cell(const Index3& fine_cell) const {
    return coarse_.place.in_lattice(fine_cell.unaryExpr(&Block::floor_half));
  }
  CellPopulation source_of(const Index3& cell, int i, int half) const {
    return {.cell = coarse_cell(cell - (1 + half) * lattice_vector(i)), .direction = i};
  }
  /// Returns the coarse cell in which a population that leaves a fine cell is after the second fine step.
  Index3 target_cell(const Index3& cell, int i, int half) const {
    return coarse_cell(cell + (2 - half) * lattice_vector(i));
  }

  /// Calls visit(fine cell, direction i) for all fine cells whose neighbour along `sign` times the velocity
  /// of i lies outside the fine level. Cells of one direction follow one another along x.
  template <class Visit>
  void for_each_crossing(int sign, Visit&& visit) const {
    for_each_outer_run(fine_.place, [&](const Index3& first, int cells) {
      for (int i = 1; i < d3q19::directions; ++i) {
        for (int n = 0; n < cells; ++n) {
          const Index3 cell = first + n * unit_vector(0);
          if (!fine_.place.contains(cell + sign * lattice_vector(i))) visit(cell, i);
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

  /// Calls visit(axis, neighbours of the source on both sides) for all axes along which a slope is needed.
  template <class Visit>
  void for_each_slope(const CellPopulation& source, Visit&& visit) const {
    for (int a = 0; a < 3; ++a) {
      CellPopulation before = source, after = source;
      before.cell = coarse_.place.in_lattice(source.cell - unit_vector(a));
      after.cell = coarse_.place.in_lattice(source.cell + unit_vector(a));
      if (!is_refined(before.cell) && !is_refined(after.cell)) visit(a, before, after);
    }
  }

  /// Sets up the exchange `numbers`, by which this rank receives the populations `wanted` of a level in each
  /// step. `sent`: populations of this rank that it reads. Returns the places of all populations. Collective.
  Places request(const Level& level, const Wanted& wanted, PopulationsByRow& sent,
                 NumberExchange& numbers) const {
    std::vector<std::vector<CellPopulation>> requests(communicator_.size());
    for (const auto& [key, population] : wanted)
      requests[level.decomposition.rank_of_cell(population.cell)].push_back(population);
    const std::vector<std::vector<CellPopulation>> requested = all_to_all(requests, communicator_);
    Wanted own;
    for (const std::vector<CellPopulation>& by_rank : requested)
      for (const CellPopulation& population : by_rank) own.emplace(key_of(level, population), population);
    Places places;
    std::vector<CellPopulation> items;
    for (const auto& [key, population] : own) {
      places[key] = static_cast<int>(items.size());
      items.push_back(population);
    }
    sent = PopulationsByRow(level.block, items);
    numbers.set_own_count(static_cast<int>(items.size()));
    for (int rank = 0; rank < communicator_.size(); ++rank) {
      if (rank == communicator_.rank()) continue;
      for (const CellPopulation& population : requested[rank])
        numbers.add_sent(rank, places.at(key_of(level, population)));
      for (const CellPopulation& population : requests[rank])
        places[key_of(level, population)] = numbers.add_received(rank);
    }
    return places;
  }

  void add_source(Key key, const CellPopulation& source, const Places& places) {
    CoarseNumbers numbers;
    numbers.centre = places.at(key);
    for_each_slope(source, [&](int axis, const CellPopulation& before, const CellPopulation& after) {
      numbers.before[axis] = places.at(key_of(coarse_, before));
      numbers.after[axis] = places.at(key_of(coarse_, after));
    });
    index_of_source_[key] = static_cast<int>(interface_.numbers_.size());
    interface_.numbers_.push_back(numbers);
  }

  int offset_index(const Vec3& offset) {
    const auto found = std::ranges::find(interface_.offsets_, offset);
    const auto index = static_cast<int>(found - interface_.offsets_.begin());
    if (found == interface_.offsets_.end()) interface_.offsets_.push_back(offset);
    return index;
  }

  Entry entry_of(const Index3& cell, int i, int half) {
    const Key key = key_of(coarse_, source_of(cell, i, half));
    const EnteringParts& parts = entering_parts_.at(key);
    Vec3 offset = offset_of(cell, i, half);
    if (parts.count == 8) offset -= parts.offsets / 8;
    return {.from = index_of_source_.at(key), .offset = offset_index(offset)};
  }

  /// Adds the population of direction i that leaves a fine cell in fine step `half`, and its arrival.
  void add_departure(const Index3& cell, int i, int half, const Places& places,
                     std::map<Key, Target>& targets) {
    const CellPopulation arrival{.cell = target_cell(cell, i, half), .direction = i};
    const bool passes = !is_refined(arrival.cell - lattice_vector(i));
    const Key departure = key_of(fine_, {.cell = cell, .direction = i});
    if (is_own(fine_, cell) && passes)
      interface_.edge_passages_.push_back({.number = places.at(departure), .entry = entry_of(cell, i, 0)});
    if (!is_own(coarse_, arrival.cell)) return;
    Target& target = targets[key_of(coarse_, arrival)];
    target.population = arrival;
    target.passes = passes;
    target.places[half].push_back(places.at(departure));
  }

  LevelInterface& interface_;
  const Level& coarse_;
  const Level& fine_;
  const Communicator& communicator_;
  std::unordered_map<Key, EnteringParts> entering_parts_;
  std::unordered_map<Key, int> index_of_source_;  ///< in LevelInterface::numbers_
};

namespace {

/// Copies outgoing populations of all planes.
void read(const Populations& populations, const PopulationsByRow& list, double* to) {
  in_precision(populations.precision(), [&]<class Real>() {
    for (int z = 0; z < list.planes(); ++z) {
      list.for_each_run(z, [&](const PopulationsByRow::Run& run, int y, int index) {
        const Real* from = populations.outgoing_row<Real>(run.direction, populations.cell(run.x, y, z));
        for (int n = 0; n < run.cells; ++n) to[index + n] = static_cast<double>(from[n]);
      });
    }
  });
}
/// Copies populations of a plane that the present step has swept. They are outgoing after the step.
void read_swept_plane(Populations& populations, const PopulationsByRow& list, int z, double* to) {
  in_precision(populations.precision(), [&]<class Real>() {
    list.for_each_run(z, [&](const PopulationsByRow::Run& run, int y, int index) {
      const Real* from = populations.next_outgoing_row<Real>(run.direction, populations.cell(run.x, y, z));
      for (int n = 0; n < run.cells; ++n) to[index + n] = static_cast<double>(from[n]);
    });
  });
}
/// Calls set(incoming population, index in the list) for all populations of a plane.
template <class Set>
void set_plane(Populations& populations, const PopulationsByRow& list, int z, Set&& set) {
  in_precision(populations.precision(), [&]<class Real>() {
    list.for_each_run(z, [&](const PopulationsByRow::Run& run, int y, int index) {
      Real* to = populations.incoming_row<Real>(run.direction, populations.cell(run.x, y, z));
      for (int n = 0; n < run.cells; ++n) set(to[n], index + n);
    });
  });
}

}  // namespace

LevelInterface::LevelInterface(const Communicator& communicator, Level& coarse, const Level& fine)
    : from_coarse_(communicator), from_fine_{NumberExchange(communicator), NumberExchange(communicator)} {
  require_room(coarse.place, fine.place);
  coarse.refined = coarse.place.parts_under(fine.place, coarse.block);
  std::erase_if(coarse.refined, [](const Block& part) { return part.is_empty(); });
  Search search(*this, coarse, fine, communicator);
  search.find_entries();
  search.find_departures();
}

void LevelInterface::begin_fine_step(const Populations& coarse, const Populations& fine) {
  NumberExchange& from_fine = from_fine_[half_];
  if (!has_numbers_) {
    read(coarse, sent_by_coarse_, from_coarse_.data());
    read(fine, departures_, from_fine.data());
    has_numbers_ = true;
  }
  const auto value_of = [&](const Entry& entry) {
    return coarse_populations_[entry.from].at(offsets_[entry.offset]);
  };
  if (half_ == 0) {
    from_coarse_.exchange(traffic_);
    for (std::size_t n = 0; n < numbers_.size(); ++n) {
      const CoarseNumbers& from = numbers_[n];
      coarse_populations_[n].value = from_coarse_[from.centre];
      for (int a = 0; a < 3; ++a)
        coarse_populations_[n].slope[a] = (from_coarse_[from.after[a]] - from_coarse_[from.before[a]]) / 2;
    }
  } else {
    for (const EdgePassage& passage : edge_passages_) from_fine[passage.number] -= value_of(passage.entry);
  }
  std::ranges::transform(entry_lists_[half_], entering_.begin(), value_of);
  from_fine.exchange(traffic_);
  arriving_.receive(half_, from_fine);
  arriving_passing_.receive(half_, from_fine);
}

void LevelInterface::set_fine_plane(Populations& fine, int z) const {
  const double* entering = entering_.data();
  set_plane(fine, entries_, z,
            [&]<class Real>(Real& incoming, int index) { incoming = static_cast<Real>(entering[index]); });
}

void LevelInterface::read_fine_plane(Populations& fine, int z) {
  read_swept_plane(fine, departures_, z, from_fine_[1 - half_].data());
}

bool LevelInterface::end_fine_step() {
  half_ = 1 - half_;
  return half_ == 0;
}

void LevelInterface::set_coarse_plane(Populations& coarse, int z) const {
  const double *sums = arriving_.sums().data(), *passing = arriving_passing_.sums().data();
  set_plane(coarse, arrivals_, z,
            [&]<class Real>(Real& incoming, int index) { incoming = static_cast<Real>(sums[index] / 8); });
  set_plane(coarse, passing_arrivals_, z, [&]<class Real>(Real& incoming, int index) {
    incoming = static_cast<Real>(static_cast<double>(incoming) + passing[index] / 8);
  });
}

void LevelInterface::read_coarse_plane(Populations& coarse, int z) {
  read_swept_plane(coarse, sent_by_coarse_, z, from_coarse_.data());
}

FluidTotals LevelInterface::in_transit() const {
  FluidTotals totals;
  if (half_ == 0) return totals;
  const auto add = [&](const PopulationsByRow& list, const double* values, int sign) {
    for (int z = 0; z < list.planes(); ++z) {
      list.for_each_run(z, [&](const PopulationsByRow::Run& run, int, int index) {
        for (int n = 0; n < run.cells; ++n) {
          const double population = sign * values[index + n];
          totals.add({.density_deviation = population, .momentum = population * velocity_of(run.direction)});
        }
      });
    }
  };
  add(departures_, from_fine_[0].data(), 1);
  add(entries_, entering_.data(), -1);
  return totals;
}

std::set<int> LevelInterface::neighbours() const {
  std::set<int> others = from_coarse_.peers();
  for (const NumberExchange& numbers : from_fine_) others.merge(numbers.peers());
  return others;
}

}  // namespace beadswim
