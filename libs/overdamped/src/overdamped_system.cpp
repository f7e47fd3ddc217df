#include "beadswim/overdamped/overdamped_system.hpp"

#include <algorithm>
#include <cmath>

#include "beadswim/collinear/pair_mobility.hpp"
#include "beadswim/core/communicator.hpp"
#include "beadswim/core/error.hpp"
#include "beadswim/core/keyed_random.hpp"
#include "beadswim/core/setting.hpp"
#include "beadswim/swimmers/swimmer_dynamics.hpp"
#include "implicit_step.hpp"
#include "lowest_mobility.hpp"
#include "thermal_noise.hpp"

namespace beadswim {
namespace {

/// Returns the sum of factor times list over all terms, for vectors per bead or numbers.
template <class Value>
std::vector<Value> weighted_sum(std::initializer_list<std::pair<double, const std::vector<Value>*>> terms) {
  std::vector<Value> sum(*terms.begin()->second);
  for (Value& value : sum) value = terms.begin()->first * value;
  for (const auto& [factor, list] : std::span(terms).subspan(1))
    for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += factor * (*list)[k];
  return sum;
}

/// Returns true if the three beads of a swimmer stay on a line, in order of their numbers.
bool has_three_beads_in_order(const SwimmerType& type) {
  if (type.beads.size() != 3 || !is_straight(type)) return false;
  const double x1 = type.beads[0].at.x(), x2 = type.beads[1].at.x(), x3 = type.beads[2].at.x();
  return (x1 < x2 && x2 < x3) || (x1 > x2 && x2 > x3);
}

}  // namespace

MobilityScene mobility_scene(const OverdampedScene& scene) {
  MobilityScene mobility = scene;
  mobility.radii = bead_radii(scene);
  const std::vector<BeadRange> ranges = bead_ranges(scene);
  for (std::size_t s = 0; s < ranges.size(); ++s) {
    if (has_three_beads_in_order(scene.type_of(scene.swimmers[s])))
      mobility.lines.push_back(static_cast<int>(ranges[s].first));
  }
  return mobility;
}

double excess_mass(const Bead& bead, double fluid_density) {
  return mass({.radius = bead.radius, .density = bead.density - fluid_density});
}

std::vector<double> excess_masses(const OverdampedScene& scene) {
  std::vector<double> masses;
  if (!scene.memory) return masses;
  for (const PlacedSwimmer& swimmer : scene.swimmers)
    for (const Bead& bead : scene.type_of(swimmer).beads)
      masses.push_back(excess_mass(bead, scene.memory->density));
  return masses;
}

OverdampedSystem::OverdampedSystem(OverdampedScene scene, const Communicator& communicator)
    : scene_(std::move(scene)),
      communicator_(communicator),
      radii_(bead_radii(scene_)),
      mobility_(mobility_scene(scene_), start_positions(scene_), communicator),
      step_scene_(new StepScene{.scene = scene_, .radii = radii_, .communicator = communicator_}) {
  if (scene_.thermal_energy > 0)
    mobility_root_ = std::make_unique<MobilityRoot>(mobility_scene(scene_), start_positions(scene_),
                                                    scene_.noise_tolerance, mobility_, communicator_);
  const Beads nowhere(radii_.size(), Vec3::Zero());
  state_.positions.fill(start_positions(scene_));
  state_.velocities.fill(nowhere);
  state_.distant.fill(nowhere);
  if (scene_.model == MobilityModel::oseen) state_.lowest_mode = nowhere;
  KeyedRandom random(1, 0, 0);
  for (Vec3& bead : state_.lowest_mode)
    for (double& component : bead) component = random.normal();
  if (const auto fault = mobility_fault())
    throw InputError(
        Setting::model,
        "the mobility of oseen is not positive definite at rest: forces would move beads backwards, most of "
        "all bead {} of swimmer {}, because beads are too close to each other or to a wall; use {} rpy",
        fault->bead.bead + 1, fault->bead.swimmer, Setting::model);
  solve_initial_velocities();
}

OverdampedSystem::~OverdampedSystem() = default;

std::pair<std::size_t, std::size_t> OverdampedSystem::own_swimmers() const {
  return rank_share(std::ssize(scene_.swimmers), communicator_.rank(), communicator_.size());
}

/// Solves one step from the present positions. Adds the mobility products that this needs to state_.work.
ImplicitStepResult OverdampedSystem::solve_step(const StepRule& rule, const StepHistory& history,
                                                const Beads& guess, const Beads& distant,
                                                const StepNoise* noise, std::span<const double> moments) {
  ImplicitStepResult result = solve_implicit_step(
      *step_scene_, mobility_, {rule, state_.positions[0], history, guess, distant, noise, moments});
  state_.work.add(result.work);
  is_converged_ = is_converged_ && result.is_converged;
  return result;
}

/// Adds the work of a solution for the moments at the end of a step.
void OverdampedSystem::add_work(const ProductWork& work) {
  state_.work.add(work);
  is_converged_ = is_converged_ && work.is_converged;
}

/// Sets the velocities of the beads at their initial positions, as the velocities of a time step of length
/// zero. In a fluid with memory, beads and fluid begin at rest.
void OverdampedSystem::solve_initial_velocities() {
  const Beads nowhere(radii_.size(), Vec3::Zero());
  const StepRule rule{.weight = 1, .span = 0, .time = time()};
  if (scene_.memory) {
    const StepHistory at_rest{.displacements = nowhere, .velocities = nowhere};
    const ImplicitBalance balance(*step_scene_, {rule, state_.positions[0], at_rest, nowhere, nowhere});
    forces_ = balance.residual(nowhere, nowhere);
    add_work(mobility_.start(forces_));
    moments_.assign(mobility_.moments().begin(), mobility_.moments().end());
    if (scene_.moment_order > 0) state_.moments.fill(moments_);
    return;
  }
  ImplicitStepResult result = solve_step(rule, {nowhere, {}}, nowhere, state_.distant[0]);
  state_.smallest_gap = result.smallest_gap;
  state_.velocities[0] = std::move(result.velocities);
  if (scene_.thermal_energy > 0) state_.smooth = state_.velocities[0];
  state_.distant[0] = std::move(result.distant);
  moments_ = std::move(result.moments);
  if (scene_.moment_order > 0 && scene_.thermal_energy == 0) state_.moments.fill(moments_);
  forces_ = std::move(result.forces);
}

/// Returns true if a bead moves by more than its radius from one list of displacements to the other.
/// Velocities that move beads so far in a step are those of stiff bonds off their rest length, and relax
/// within it. All ranks use the value of rank 0, because roundoff may differ between processors.
bool OverdampedSystem::moves_far(const Beads& from, const Beads& to) const {
  int is_far = 0;
  for (std::size_t b = 0; b < from.size(); ++b)
    if ((to[b] - from[b]).norm() > radii_[b]) is_far = 1;
  MPI_Bcast(&is_far, 1, MPI_INT, 0, communicator_.get());
  return is_far == 1;
}

/// Takes one step of length h as `parts` implicit Euler substeps: u_k = u_{k-1} + (h/parts) v_k.
ImplicitStepResult OverdampedSystem::take_euler_steps(int parts) {
  const double span = scene_.step / parts;
  ImplicitStepResult step{.displacements = Beads(radii_.size(), Vec3::Zero()),
                          .velocities = state_.velocities[0],
                          .distant = state_.distant[0]};
  for (int k = 1; k <= parts; ++k) {
    const StepRule rule{.weight = 1, .span = span, .time = time() + k * span};
    Beads guess = weighted_sum<Vec3>({{1, &step.displacements}, {span, &step.velocities}});
    if (moves_far(step.displacements, guess)) guess = step.displacements;
    step = solve_step(rule, {step.displacements, {}}, guess, step.distant);
  }
  return step;
}

/// Takes one step of third order. The results of 1, 2 and 3 implicit Euler substeps are extrapolated, so that
/// the errors of order h and h^2 cancel.
void OverdampedSystem::take_first_step() {
  const ImplicitStepResult one = take_euler_steps(1), two = take_euler_steps(2), three = take_euler_steps(3);
  state_.smallest_gap = std::min(state_.smallest_gap, three.smallest_gap);
  const auto extrapolated = [&]<class Value>(std::vector<Value> ImplicitStepResult::*part) {
    return weighted_sum<Value>({{0.5, &(one.*part)}, {-4, &(two.*part)}, {4.5, &(three.*part)}});
  };
  const bool have_equal_moments =  // unless beads come so close in the step that they get stresslets
      one.moments.size() == three.moments.size() && two.moments.size() == three.moments.size();
  accept({.displacements = extrapolated(&ImplicitStepResult::displacements),
          .velocities = extrapolated(&ImplicitStepResult::velocities),
          .forces = extrapolated(&ImplicitStepResult::forces),
          .moments = have_equal_moments ? extrapolated(&ImplicitStepResult::moments) : three.moments,
          .distant = extrapolated(&ImplicitStepResult::distant)});
}

/// Returns the values in the next step, from those now and in earlier steps: by the cubic polynomial closest
/// to the last six, because that through four would multiply their errors by eight; by a quadratic polynomial
/// in the first steps.
template <class Value>
std::vector<Value> OverdampedSystem::extrapolated(const std::array<std::vector<Value>, 6>& past) const {
  const auto& [p, p1, p2, p3, p4, p5] = past;
  if (state_.steps_done < 6) return weighted_sum<Value>({{3, &p}, {-3, &p1}, {1, &p2}});
  return weighted_sum<Value>(
      {{8. / 3, &p}, {-4. / 3, &p1}, {-4. / 3, &p2}, {1. / 3, &p3}, {4. / 3, &p4}, {-2. / 3, &p5}});
}

/// Takes one step by the backward difference formula of third order. It uses displacements from the present
/// positions, because coordinates may be large and would lose significance.
void OverdampedSystem::take_bdf_step() {
  const auto& [x, x1, x2] = state_.positions;
  const auto& [v, v1, v2] = state_.velocities;
  const double h = scene_.step;
  const Beads u1 = weighted_sum<Vec3>({{1, &x1}, {-1, &x}}), u2 = weighted_sum<Vec3>({{1, &x2}, {-1, &x}});
  const StepRule rule{.weight = 11.0 / 6, .span = h, .time = time() + h};
  // The initial guess of the new positions is the cubic polynomial in time through the positions x and x_1
  // with the velocities v and v_1 as slopes.
  StepHistory history{.displacements = weighted_sum<Vec3>({{-1.5, &u1}, {1.0 / 3, &u2}}), .velocities = {}};
  if (scene_.memory) history.velocities = weighted_sum<Vec3>({{3, &v}, {-1.5, &v1}, {1.0 / 3, &v2}});
  ImplicitStepResult result =
      solve_step(rule, history, weighted_sum<Vec3>({{5, &u1}, {4 * h, &v}, {2 * h, &v1}}),
                 extrapolated(state_.distant), nullptr, extrapolated(state_.moments));
  state_.smallest_gap = std::min(state_.smallest_gap, result.smallest_gap);
  if (scene_.memory) mobility_.end_step(result.moments, beadswim::mean_flow(*step_scene_, result.velocities));
  accept(std::move(result));
}

/// Takes one step of the implicit midpoint rule with thermal noise: half a step of implicit Euler, continued
/// to a whole one. The mobility is that at the middle of a step with the velocities of the last step, whose
/// noise does not depend on the present one.
void OverdampedSystem::take_noisy_step() {
  const double half = scene_.step / 2;
  const Beads nowhere(radii_.size(), Vec3::Zero());
  ThermalNoise thermal =
      thermal_noise(*step_scene_, mobility_, *mobility_root_, state_.positions[0], state_.steps_done);
  add_work(thermal.work);
  is_converged_ = is_converged_ && thermal.is_converged;
  state_.noise_error = std::max(state_.noise_error, thermal.error);
  const StepNoise noise{.velocities = std::move(thermal.velocities),
                        .mobility_at = weighted_sum<Vec3>({{half, &state_.smooth}})};
  const StepRule rule{.weight = 1, .span = half, .time = time() + half};
  const Beads distant = weighted_sum<Vec3>({{1, &state_.distant[0]}, {1, &noise.velocities}});
  ImplicitStepResult result = solve_step(rule, {nowhere, {}}, nowhere, distant, &noise);
  state_.smallest_gap = std::min(state_.smallest_gap, result.smallest_gap);
  flat(result.displacements) *= 2;
  flat(result.distant) -= flat(noise.velocities);
  state_.smooth = weighted_sum<Vec3>({{1, &result.velocities}, {-1, &noise.velocities}});
  accept(std::move(result));
}

// The fluid that a bead displaces moves with it, so that the bead exerts F on the fluid beyond the force on
// that part: force of the fluid on the bead = -F + m_f dv/dt.
std::vector<Vec3> OverdampedSystem::fluid_forces() const {
  std::vector<Vec3> forces;
  const auto& [now, before, earlier] = state_.velocities;
  for (std::size_t b = 0; b < forces_.size(); ++b) {
    const Vec3 acceleration = (1.5 * now[b] - 2 * before[b] + 0.5 * earlier[b]) / scene_.step;
    const double displaced =
        scene_.memory ? mass({.radius = radii_[b], .density = scene_.memory->density}) : 0;
    forces.emplace_back(displaced * acceleration - forces_[b]);
  }
  return forces;
}

Vec3 OverdampedSystem::mean_flow() const {
  return beadswim::mean_flow(*step_scene_, state_.velocities[0]);
}

Vec3 OverdampedSystem::momentum() const {
  const Beads& velocities = state_.velocities[0];
  return step_scene_->fluid_mass * mean_flow() + excess_momentum(*step_scene_, velocities);
}

void OverdampedSystem::accept(ImplicitStepResult step) {
  const auto keep = [](auto& past, auto now) {
    std::rotate(past.begin(), past.end() - 1, past.end());
    past[0] = std::move(now);
  };
  keep(state_.positions, weighted_sum<Vec3>({{1, &state_.positions[0]}, {1, &step.displacements}}));
  keep(state_.velocities, std::move(step.velocities));
  keep(state_.distant, std::move(step.distant));
  moments_ = std::move(step.moments);
  if (!state_.moments[0].empty()) keep(state_.moments, moments_);
  forces_ = std::move(step.forces);
  ++state_.steps_done;
  update_extremes();
  check_faults();
  if (!fault_ && (must_check_mobility() || !is_converged_)) fault_ = mobility_fault();
  if (!is_converged_ && !fault_) fault_ = {.kind = FaultKind::not_converged, .step = state_.steps_done};
}

void OverdampedSystem::step() {
  if (fault_) {
    ++state_.steps_done;
    return;
  }
  if (scene_.thermal_energy > 0) return take_noisy_step();
  state_.steps_done < 2 && !scene_.memory ? take_first_step() : take_bdf_step();
}

void OverdampedSystem::update_extremes() {
  for (std::size_t b = 0; b < radii_.size(); ++b) {
    const Vec3& velocity = state_.smooth.empty() ? state_.velocities[0][b] : state_.smooth[b];
    const Vec3 slip = velocity - scene_.flow.at(state_.positions[0][b]);
    state_.largest_speed = std::max(state_.largest_speed, slip.norm());
    if (scene_.domain.half_space)
      state_.smallest_relative_height =
          std::min(state_.smallest_relative_height,
                   scene_.domain.half_space->height(state_.positions[0][b]) / radii_[b]);
  }
}

/// Returns true if beads have come closer to each other or to the wall since the last check of the mobility,
/// which costs several products, and otherwise after a number of steps.
bool OverdampedSystem::must_check_mobility() const {
  constexpr double closer = 0.01;  // relative to a radius
  constexpr long interval = 100;
  return state_.steps_done >= state_.checked_steps + interval ||
         state_.smallest_gap / *std::ranges::min_element(radii_) < state_.checked_gap - closer ||
         state_.smallest_relative_height < state_.checked_height - closer;
}

/// Returns the fault of a mobility that is not positive definite.
std::optional<Fault> OverdampedSystem::mobility_fault() {
  if (state_.lowest_mode.empty()) return std::nullopt;
  state_.checked_steps = state_.steps_done;
  state_.checked_gap = state_.smallest_gap / *std::ranges::min_element(radii_);
  state_.checked_height = state_.smallest_relative_height;
  if (!has_close_spheres(positions(), radii_, scene_.domain)) return std::nullopt;
  Eigen::VectorXd root_mobility(3 * radii_.size());
  for (std::size_t b = 0; b < radii_.size(); ++b)
    root_mobility.segment<3>(3 * b).setConstant(std::sqrt(self_mobility(radii_[b], scene_.viscosity)));
  const auto bead =
      find_reversed_bead(mobility_, positions(), root_mobility, state_.lowest_mode, communicator_);
  if (!bead) return std::nullopt;
  const std::vector<BeadRange> ranges = bead_ranges(scene_);
  const auto owner = std::ranges::upper_bound(ranges, *bead, {}, &BeadRange::first) - 1;
  return Fault{.kind = FaultKind::not_positive,
               .step = state_.steps_done,
               .bead = {.swimmer = scene_.swimmers[owner - ranges.begin()].id,
                        .bead = static_cast<int>(*bead - owner->first)},
               .position = positions()[*bead]};
}

/// Records the first fault in this step, if there is one. Each rank stores all beads, so that all ranks find
/// the same fault.
void OverdampedSystem::check_faults() {
  const auto& [now, before, earlier] = state_.positions;
  const std::vector<BeadRange> ranges = bead_ranges(scene_);
  for (std::size_t s = 0; s < ranges.size(); ++s) {
    const SwimmerType& type = scene_.type_of(scene_.swimmers[s]);
    const int id = scene_.swimmers[s].id;
    const std::size_t first = ranges[s].first;
    for (std::size_t b = first; b < ranges[s].last; ++b) {
      const auto record = [&, &before = before](FaultKind kind, double value) {
        keep_first(fault_, {.kind = kind,
                            .step = state_.steps_done,
                            .bead = {id, static_cast<int>(b - first)},
                            .position = before[b],
                            .value = value});
      };
      const Vec3 drift = scene_.step * scene_.flow.at(before[b]);
      const double moved = (now[b] - before[b] - drift).norm() / radii_[b];
      if (!std::isfinite(moved)) record(FaultKind::not_finite, moved);
      if (moved > 1) record(FaultKind::displacement, moved);
      if (const double into =
              scene_.domain.half_space ? radii_[b] - scene_.domain.half_space->height(now[b]) : 0;
          into > 0)
        record(FaultKind::in_wall, into / radii_[b]);
      for (int a = 0; a < 3 && scene_.domain.box; ++a) {
        const double beyond = std::max(-now[b][a], now[b][a] - scene_.domain.box->lengths[a]);
        if (scene_.domain.box->has_mirrors(a) && beyond > 0) record(FaultKind::beyond_wall, beyond);
      }
    }
    auto torn = torn_arm(type, id, [&, &now = now](int b) { return now[first + b]; });
    if (!torn) continue;
    torn->step = state_.steps_done;
    torn->position = before[first + torn->bead.bead];
    keep_first(fault_, *torn);
  }
}

void OverdampedSystem::restore(OverdampedState state, std::span<const double> memory) {
  const auto has_all_beads = [&](const Beads& list) { return list.size() == radii_.size(); };
  if (!std::ranges::all_of(state.positions, has_all_beads) ||
      !std::ranges::all_of(state.velocities, has_all_beads) ||
      !std::ranges::all_of(state.distant, has_all_beads) ||
      !std::ranges::equal(state.moments, state_.moments, {}, &std::vector<double>::size,
                          &std::vector<double>::size) ||
      state.lowest_mode.size() != state_.lowest_mode.size() || state.smooth.size() != state_.smooth.size())
    throw DataError("the number of beads in the checkpoint differs from the number of beads in the layout");
  state_ = std::move(state);
  if (scene_.memory) mobility_.restore_memory(memory);
}

}  // namespace beadswim
