#include "beadswim/coupling/coupled_system.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "beadswim/core/error.hpp"
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
      links_(scene.bead_boundary, levels_.finest().rates),
      saturated_cells_(in_box(levels_.finest()), lattice_viscosity(scene.relaxation_time)) {
  levels_.set_wall_velocities(scene_.walls);
  progress_.body_force = scene_.body_force;
  has_net_force_ = needs_balance(scene_);
  for (const SwimmerType& type : scene_.types) substeps_.push_back(substeps_for(type, 1));
  const std::vector<Vec3> places = start_positions(scene_);
  auto place = places.begin();
  for (const PlacedSwimmer& swimmer : scene_.swimmers) {
    SwimmerState state = SwimmerState::of_beads(scene_.type_of(swimmer).beads.size());
    state.id = swimmer.id;
    state.type = swimmer.type;
    for (int a = 0; a < 3; ++a) state.initial_orientation[a] = swimmer.orientation.col(a);
    for (BeadMotion& bead : state.motion) bead.position = *place++;
    if (owns(state)) owned_.push_back(std::move(state));
  }
  beads_ = exchange_.publish(owned_);
  coverage_.update(beads_);
  find_links_and_contacts();
  fault_.reset();  // beads that overlap at the start are a fault of the first step
}

std::optional<Fault> CoupledSystem::fault_of(const SwimmerState& swimmer) {
  const std::vector<BeadAtRest>& bodies = scene_.types[swimmer.type].beads;
  const int beads = static_cast<int>(bodies.size());
  for (int b = 0; b < beads; ++b) {
    const BeadMotion& motion = swimmer.motion[b];
    const double speed = motion.velocity.norm() + bodies[b].radius * motion.angular_velocity.norm();
    if (speed <= speed_limit) {
      if (!fault_)
        progress_.largest_bead_speed = std::max(progress_.largest_bead_speed, motion.velocity.norm());
      continue;
    }
    return Fault{.kind = std::isfinite(speed) ? FaultKind::speed : FaultKind::not_finite,
                 .bead = {swimmer.id, b},
                 .position = motion.position,
                 .value = speed};
  }
  return exchange_.position_fault(swimmer);
}

void CoupledSystem::record_fault(Fault fault) {
  fault.step = progress_.steps_done;
  keep_first(fault_, fault);
}

double CoupledSystem::smallest_gap() const {
  double smallest = progress_.smallest_gap;
  MPI_Allreduce(MPI_IN_PLACE, &smallest, 1, MPI_DOUBLE, MPI_MIN, communicator_.get());
  return smallest;
}

double CoupledSystem::largest_bead_speed() const {
  double largest = progress_.largest_bead_speed;
  MPI_Allreduce(MPI_IN_PLACE, &largest, 1, MPI_DOUBLE, MPI_MAX, communicator_.get());
  return largest;
}

std::vector<SwimmerState> CoupledSystem::gather_swimmers() const {
  auto swimmers = values_from_bytes<SwimmerState>(gather_bytes(bytes_of(owned_), communicator_));
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
  auto snapshots = values_from_bytes<SwimmerSnapshot>(gather_bytes(bytes_of(own), communicator_));
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
  levels_.set_body_impulses(progress.body_impulses);
  progress_ = progress;
}

void CoupledSystem::add_pending_impulses(std::map<BeadName, Impulse>& impulses) {
  for (const auto& [name, impulse] : pending_impulses_) impulses[name].add(impulse);
}

}  // namespace beadswim
