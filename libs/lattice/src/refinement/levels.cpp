#include "beadswim/lattice/levels.hpp"

#include <cmath>

#include "beadswim/lattice/fluid_step.hpp"
#include "level_interface.hpp"

namespace beadswim {
namespace {

/// Returns the relaxation time tau of a level [step of the level]. The viscosity and the speed of sound are
/// the same on all levels.
///
///   tau - 1/2 = (tau_finest - 1/2)/2^n
///
/// tau_finest: relaxation time of the finest level;  n: number of finer levels
double relaxation_time_of_level(double finest, int finer_levels) {
  return 0.5 + std::ldexp(finest - 0.5, -finer_levels);
}

}  // namespace

std::vector<Block> LevelPlace::parts_under(const LevelPlace& finer, const Block& block) const {
  Block refined = finer.lattice.halved();
  refined.offset = in_lattice(refined.offset);
  Index3 copies;
  for (int a = 0; a < 3; ++a) copies[a] = boundary[a] == Boundary::periodic ? 1 : 0;
  std::vector<Block> parts;
  for (int x = -copies[0]; x <= 0; ++x) {
    for (int y = -copies[1]; y <= 0; ++y) {
      for (int z = -copies[2]; z <= 0; ++z) {
        const Index3 first = refined.offset + Index3(x, y, z) * box - block.offset;
        const Index3 low = first.max(0), high = (first + refined.size).min(block.size);
        parts.push_back({.offset = low, .size = (high - low).max(0)});
      }
    }
  }
  return parts;
}

Level::Level(const LevelPlace& place_of_level, double relaxation_time, Precision precision,
             HaloContent content, const Communicator& communicator)
    : place(place_of_level),
      decomposition(place.lattice, communicator.size(), min_thickness(content)),
      block(decomposition.block(communicator.rank())),
      populations(block.size, precision, content),
      halo(communicator, decomposition, place.boundary, content,
           {!place.spans(0), !place.spans(1), !place.spans(2)}),
      rates(relaxation_rates(relaxation_time)) {}

std::vector<LevelPlace> places_in_box(const Index3& cells, const std::array<Boundary, 3>& boundary,
                                      std::span<const Block> lattices) {
  std::vector<LevelPlace> places;
  for (std::size_t n = 0; n < lattices.size(); ++n) {
    const int finer_levels = static_cast<int>(lattices.size() - 1 - n);
    places.push_back({.lattice = lattices[n], .box = cells / (1 << finer_levels), .boundary = boundary});
  }
  return places;
}

Levels::Levels(const std::vector<LevelPlace>& places, double relaxation_time, Precision precision,
               HaloContent content, const Communicator& communicator) {
  std::vector<SharedCells> lattices;
  for (const LevelPlace& place : places) lattices.push_back({.cells = place.lattice.size});
  lattices.back().thickness = min_thickness(content);
  require_grids(lattices, communicator.size());
  const int count = static_cast<int>(places.size());
  for (int n = 0; n < count; ++n) {
    const int finer_levels = count - 1 - n;
    levels_.push_back(
        std::make_unique<Level>(places[n], relaxation_time_of_level(relaxation_time, finer_levels), precision,
                                finer_levels == 0 ? content : HaloContent::entering, communicator));
    if (n > 0)
      interfaces_.push_back(std::make_unique<LevelInterface>(communicator, *levels_[n - 1], *levels_[n]));
  }
  impulses_.resize(count);
}

Levels::~Levels() = default;

void Levels::set_wall_velocities(const std::array<WallVelocities, 3>& walls) {
  for (const auto& level : levels_) {
    for (int axis = 0; axis < 3; ++axis) level->halo.set_wall_velocities(axis, walls[axis]);
  }
}

void Levels::step(const Vec3& body_force, const std::function<void(int, int)>& before_row) {
  for (BodyImpulse& impulse : impulses_) impulse.pending += body_force;
  advance(count() - 1, before_row);
}

void Levels::advance(int n, const std::function<void(int, int)>& before_row) {
  Level& level = *levels_[n];
  Populations& fluid = level.populations;
  LevelInterface* const to_coarser = n > 0 ? interfaces_[n - 1].get() : nullptr;
  LevelInterface* const to_finer = n + 1 < count() ? interfaces_[n].get() : nullptr;
  if (to_coarser) to_coarser->begin_fine_step(levels_[n - 1]->populations, fluid);
  BodyImpulse& impulse = impulses_[n];
  impulse.acted = acting_body_force(impulse.pending, fluid.precision());
  impulse.pending -= impulse.acted;
  const auto before_plane = [&](int z) {
    if (to_coarser) to_coarser->set_fine_plane(fluid, z);
    if (to_finer) to_finer->set_coarse_plane(fluid, z);
  };
  const auto after_plane = [&](int z) {
    if (to_coarser) to_coarser->read_fine_plane(fluid, z);
    if (to_finer) to_finer->read_coarse_plane(fluid, z);
  };
  step_fluid(fluid, level.halo, level.rates, impulse.acted,
             {.before_row = before_row, .before_plane = before_plane, .after_plane = after_plane},
             level.refined);
  if (to_coarser && to_coarser->end_fine_step()) advance(n - 1, {});  // coarser levels contain no beads
}

std::vector<FluidTotals> Levels::coarser_totals() const {
  std::vector<FluidTotals> totals;
  for (int n = 0; n + 1 < count(); ++n) {
    totals.push_back(block_totals(levels_[n]->populations, levels_[n]->refined));
    totals.push_back(interfaces_[n]->in_transit());
  }
  return totals;
}

CellMoments Levels::sum_of_coarser(std::vector<FluidTotals> totals, const Communicator& communicator) const {
  totals.resize(2 * (count() - 1));
  CellMoments sum;
  const auto add = [&](const FluidTotals& own, int finer_levels) {
    const FluidTotals all = sum_over_ranks(own, communicator);
    const double volume = std::ldexp(1.0, 3 * finer_levels);
    sum.density_deviation += volume * all.density_deviation.value();
    sum.momentum += volume * all.momentum_value();
  };
  for (int n = 0; n + 1 < count(); ++n) {
    const int finer_levels = count() - 1 - n;
    add(totals[2 * n], finer_levels);
    add(totals[2 * n + 1], finer_levels - 1);
  }
  for (int n = 0; n < count(); ++n) sum.momentum += volume(n) * impulses_[n].pending;
  return sum;
}

double Levels::volume(int n) const {
  const auto cells = [&](int level) { return levels_[level]->place.lattice.size.cast<double>().prod(); };
  const double refined = n + 1 < count() ? cells(n + 1) / 8 : 0;
  return std::ldexp(cells(n) - refined, 3 * (count() - 1 - n));
}

Vec3 Levels::half_impulse() const {
  Vec3 sum = Vec3::Zero();
  for (int n = 0; n < count(); ++n) sum += 0.5 * volume(n) * impulses_[n].acted;
  return sum;
}

std::set<int> Levels::neighbours() const {
  std::set<int> others;
  for (const auto& level : levels_) others.merge(level->halo.neighbours());
  for (const auto& between : interfaces_) others.merge(between->neighbours());
  return others;
}

Traffic Levels::traffic() const {
  Traffic sent;
  for (const auto& level : levels_) sent.add(level->halo.traffic());
  for (const auto& between : interfaces_) sent.add(between->traffic());
  return sent;
}

}  // namespace beadswim
