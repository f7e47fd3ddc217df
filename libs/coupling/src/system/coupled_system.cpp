#include "beadswim/coupling/coupled_system.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "beadswim/core/error.hpp"
#include "beadswim/core/message.hpp"
#include "beadswim/coupling/force_delay.hpp"
#include "beadswim/swimmers/swimmer_forces.hpp"
#include "beadswim/swimmers/swimmer_shape.hpp"

namespace beadswim {
namespace {

/// Returns true if driving forces of a swimmer do not sum to zero and no wall takes up their momentum: there
/// is a periodic axis and no no-slip wall.
bool needs_balance(const CoupledScene& scene) {
  if (std::ranges::count(scene.boundary, Boundary::no_slip) > 0 ||
      std::ranges::count(scene.boundary, Boundary::periodic) == 0)
    return false;
  return std::ranges::any_of(scene.types,
                             [](const SwimmerType& type) { return !net_forces(type.driving).empty(); });
}

/// Returns the state of a swimmer whose beads do not move.
SwimmerState at_rest(const PlacedSwimmer& swimmer, std::span<const Vec3> places) {
  SwimmerState state = SwimmerState::of_beads(places.size());
  state.id = swimmer.id;
  state.type = swimmer.type;
  for (int a = 0; a < 3; ++a) state.initial_orientation[a] = swimmer.orientation.col(a);
  for (std::size_t b = 0; b < places.size(); ++b) state.motion[b].position = places[b];
  return state;
}

BlockInLattice in_box(const Level& level) {
  return {.block = level.block, .cells = level.place.box, .boundary = level.place.boundary};
}

}  // namespace

CoupledSystem::CoupledSystem(const CoupledScene& scene, const Communicator& communicator)
    : communicator_(communicator),
      scene_(scene),
      levels_(places_in_box(scene.cells, scene.boundary, scene.all_levels()), scene.relaxation_time,
              scene.precision, halo_content(scene.bead_boundary), communicator),
      exchange_(communicator, levels_.finest().decomposition, scene_),
      near_contact_(near_contact_law(scene_)),
      coverage_(in_box(levels_.finest()), levels_.finest().populations),
      links_(scene.bead_boundary),
      saturated_cells_(in_box(levels_.finest())),
      smallest_gap_(std::numeric_limits<double>::infinity()) {
  levels_.set_wall_velocities(scene_.walls);
  body_force_ = scene_.body_force;
  has_net_force_ = needs_balance(scene_);
  for (const SwimmerType& type : scene_.types) substeps_.push_back(substeps_for(type, 1));
  const std::vector<Vec3> places = start_positions(scene_);
  const std::vector<BeadRange> ranges = bead_ranges(scene_);
  for (std::size_t s = 0; s < ranges.size(); ++s) {
    const auto [first, last] = ranges[s];
    SwimmerState state = at_rest(scene_.swimmers[s], std::span(places).subspan(first, last - first));
    if (owns(state)) owned_.push_back(std::move(state));
  }
  beads_ = exchange_.publish(owned_);
  coverage_.update(beads_);
  find_links_and_contacts();
}

std::optional<Fault> CoupledSystem::fault_of(const SwimmerState& swimmer) {
  const std::vector<BeadAtRest>& bodies = scene_.types[swimmer.type].beads;
  const int beads = static_cast<int>(bodies.size());
  for (int b = 0; b < beads; ++b) {
    const BeadMotion& motion = swimmer.motion[b];
    const double speed = motion.velocity.norm() + bodies[b].radius * motion.angular_velocity.norm();
    if (speed <= speed_limit) {
      if (!fault_) largest_bead_speed_ = std::max(largest_bead_speed_, motion.velocity.norm());
      continue;
    }
    return Fault{.kind = std::isfinite(speed) ? FaultKind::speed : FaultKind::not_finite,
                 .bead = {swimmer.id, b},
                 .position = motion.position,
                 .value = speed};
  }
  if (const auto fault = exchange_.position_fault(swimmer)) return fault;
  for (int i = 0; i < beads; ++i) {
    const Vec3& place = swimmer.motion[i].position;
    for (int j = i + 1; j < beads; ++j) {
      const double gap = (swimmer.motion[j].position - place).norm() - bodies[i].radius - bodies[j].radius;
      if (!fault_ && gap < near_contact_.cutoff()) smallest_gap_ = std::min(smallest_gap_, gap);
      if (const auto fault = overlap_of({swimmer.id, i}, {swimmer.id, j}, place, gap,
                                        std::min(bodies[i].radius, bodies[j].radius)))
        return fault;
    }
  }
  return std::nullopt;
}

void CoupledSystem::record_fault(Fault fault) {
  fault.step = steps_done_;
  if (!fault_ || comes_before(fault, *fault_)) fault_ = fault;
}

double CoupledSystem::smallest_gap() const {
  double smallest = smallest_gap_;
  MPI_Allreduce(MPI_IN_PLACE, &smallest, 1, MPI_DOUBLE, MPI_MIN, communicator_.get());
  return smallest;
}

double CoupledSystem::largest_bead_speed() const {
  double largest = largest_bead_speed_;
  MPI_Allreduce(MPI_IN_PLACE, &largest, 1, MPI_DOUBLE, MPI_MAX, communicator_.get());
  return largest;
}

std::vector<SwimmerState> CoupledSystem::gather_swimmers() const {
  OutgoingMessage message;
  for (const SwimmerState& swimmer : owned_) message(swimmer);
  std::vector<SwimmerState> swimmers;
  IncomingMessage gathered(gather_bytes(message.bytes(), communicator_));
  while (!gathered.is_at_end()) gathered(swimmers.emplace_back());
  std::ranges::sort(swimmers, {}, &SwimmerState::id);
  return swimmers;
}

std::vector<SwimmerSnapshot> CoupledSystem::gather_snapshots() {
  std::map<BeadName, Impulse> impulses = exchange_.collect(beads_);
  add_pending_impulses(impulses);
  std::vector<SwimmerSnapshot> own;
  for (const SwimmerState& swimmer : owned_) {
    SwimmerSnapshot& snapshot = own.emplace_back();
    snapshot.state = swimmer;
    for (int b = 0; b < std::ssize(swimmer.motion); ++b)
      snapshot.pending_impulses.push_back(impulses[{swimmer.id, b}]);
  }
  auto snapshots = snapshots_from_bytes(gather_bytes(bytes_of(own), communicator_));
  std::ranges::sort(snapshots, {}, [](const SwimmerSnapshot& s) { return s.state.id; });
  return snapshots;
}

Traffic CoupledSystem::traffic() const {
  Traffic sent = levels_.traffic();
  sent.add(exchange_.traffic());
  return sent;
}

int CoupledSystem::neighbours() const {
  std::set<int> others = levels_.neighbours();
  others.insert(exchange_.peers().begin(), exchange_.peers().end());
  others.erase(communicator_.rank());
  return static_cast<int>(others.size());
}

void CoupledSystem::restore(const SystemProgress& progress, std::span<const SwimmerSnapshot> swimmers,
                            const std::function<void(Levels&)>& fill) {
  owned_.clear();
  pending_impulses_.clear();
  for (const SwimmerSnapshot& swimmer : swimmers) {
    if (!owns(swimmer.state)) continue;
    owned_.push_back(swimmer.state);
    for (int b = 0; b < std::ssize(swimmer.pending_impulses); ++b)
      pending_impulses_[{swimmer.state.id, b}] = swimmer.pending_impulses[b];
  }
  beads_ = exchange_.publish(owned_);
  coverage_.update(beads_);
  fill(levels_);
  find_links_or_saturated_cells();
  fault_.reset();
  state_is_finite_ = true;
  steps_done_ = progress.steps_done;
  body_force_ = progress.body_force;
  unbalanced_ = progress.unbalanced;
  levels_.set_body_impulses(progress.body_impulses);
  largest_bead_speed_ = progress.largest_bead_speed;
  smallest_gap_ = progress.smallest_gap;
}

void CoupledSystem::add_pending_impulses(std::map<BeadName, Impulse>& impulses) {
  for (const auto& [name, impulse] : pending_impulses_) impulses[name].add(impulse);
}

FluidTotals CoupledSystem::fluid_totals() const {
  FluidTotals fluid = block_totals(populations());
  if (has_links(scene_.bead_boundary)) {
    FluidTotals covered_cells;
    coverage_.for_each_own_covered_cell(
        [&](std::ptrdiff_t cell, int, const Vec3&) { covered_cells.add(cell_moments(populations(), cell)); });
    fluid.subtract(covered_cells);
    return fluid;
  }
  for (const SwimmerState& swimmer : owned_) {
    for (const Load& inner : swimmer.inner_momentum)
      fluid.add({.density_deviation = 0, .momentum = -inner.force});
  }
  return fluid;
}

FluidTotals CoupledSystem::volume_of_beads() const {
  FluidTotals totals;
  const Vec3 half_impulse = 0.5 * levels_.body_impulses().back().acted;
  if (has_links(scene_.bead_boundary)) {
    coverage_.for_each_own_covered_cell([&](std::ptrdiff_t, int bead, const Vec3& from_centre) {
      totals.add({.density_deviation = 0, .momentum = beads_[bead].velocity_at(from_centre) + half_impulse});
    });
    return totals;
  }
  for_each_owned_bead([&](const SwimmerState& swimmer, std::size_t b, const Bead& bead) {
    // The momentum of the fluid within the bead lacks the last impulse of the body force.
    const Vec3 velocity = swimmer.motion[b].velocity - half_impulse;
    totals.add({.density_deviation = 0, .momentum = mass(bead) / bead.density * velocity});
  });
  for (const auto& [cell, fluid_fraction, force] : saturated_forces_)
    totals.add({.density_deviation = 0, .momentum = -0.5 * fluid_fraction * force});
  return totals;
}

FluidTotals CoupledSystem::excess_totals() const {
  FluidTotals totals;
  for_each_owned_bead([&](const SwimmerState& swimmer, std::size_t b, const Bead& bead) {
    const double added = scene_.corrects_delay ? delay_density(bead, scene_.relaxation_time) : 0;
    const double excess = mass(bead) * (1 - (1 + added) / bead.density);
    totals.add({.density_deviation = 0, .momentum = excess * swimmer.motion[b].velocity});
  });
  return totals;
}

FluidTotals CoupledSystem::bead_totals() const {
  FluidTotals totals;
  for_each_owned_bead([&](const SwimmerState& swimmer, std::size_t b, const Bead& bead) {
    totals.add(
        {.density_deviation = swimmer.held_mass[b], .momentum = mass(bead) * swimmer.motion[b].velocity});
    totals.add({.density_deviation = 0, .momentum = 0.5 * swimmer.last_impulse[b].force});
  });
  const auto add = [&](const Impulse& impulse) {  // exact sums: rounding would depend on the number of ranks
    totals.density_deviation.add(impulse.mass);
    for (int a = 0; a < 3; ++a) totals.momentum[a].add(impulse.linear[a]);
  };
  for (const BeadOnLattice& bead : beads_) add(bead.impulse);
  for (const auto& [name, impulse] : pending_impulses_) add(impulse);
  return totals;
}

SceneTotals CoupledSystem::totals() {
  FluidTotals everything, all_cells;
  std::vector<FluidTotals> coarser_totals;
  if_state_is_finite([&] {
    everything = all_cells = fluid_totals();
    everything.add(bead_totals());
    all_cells.add(volume_of_beads());
    coarser_totals = levels_.coarser_totals();
  });
  everything = sum_over_ranks(everything, communicator_);
  all_cells = sum_over_ranks(all_cells, communicator_);
  const CellMoments coarser = levels_.sum_of_coarser(std::move(coarser_totals), communicator_);
  const double cells = scene_.cells.cast<double>().prod();
  const Vec3 half_impulse = levels_.half_impulse();
  // Momentum is conserved if a body force that balances driving forces is counted with these forces.
  const Vec3 ahead = has_net_force_ ? unbalanced_ : half_impulse;
  return {.momentum = everything.momentum_value() + coarser.momentum - ahead,
          .mean_flow = (all_cells.momentum_value() + coarser.momentum - half_impulse) / cells,
          .mass_excess = (everything.density_deviation.value() + coarser.density_deviation) / cells};
}

}  // namespace beadswim
