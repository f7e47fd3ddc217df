#include "beadswim/overdamped/overdamped_system.hpp"

#include <algorithm>
#include <cmath>

#include "beadswim/core/error.hpp"
#include "beadswim/core/rank_share.hpp"
#include "beadswim/core/setting.hpp"
#include "implicit_step.hpp"

namespace beadswim {
namespace {

/// sum_i factor_i beads_i.
Beads combined(std::initializer_list<std::pair<double, const Beads*>> terms) {
  Beads sum(terms.begin()->second->size(), Vec3::Zero());
  for (const auto& [factor, beads] : terms)
    for (std::size_t b = 0; b < sum.size(); ++b) sum[b] += factor * (*beads)[b];
  return sum;
}

}  // namespace

OverdampedSystem::OverdampedSystem(OverdampedScene scene, const Communicator& communicator)
    : scene_(std::move(scene)),
      communicator_(communicator),
      radii_(bead_radii(scene_)),
      mobility_({scene_.model, scene_.viscosity, scene_.box, radii_, scene_.tolerance},
                rest_positions(scene_), communicator),
      implicit_step_(std::make_unique<ImplicitStep>(scene_, radii_, mobility_, communicator_)) {
  const Beads nowhere(radii_.size(), Vec3::Zero());
  state_.positions.fill(rest_positions(scene_));
  state_.velocities.fill(nowhere);
  state_.distant.fill(nowhere);
  find_velocities();
}

OverdampedSystem::~OverdampedSystem() = default;

std::pair<std::size_t, std::size_t> OverdampedSystem::own_swimmers() const {
  return rank_share(std::ssize(scene_.swimmers), communicator_.rank(), communicator_.size());
}

/// From the positions now; counts what it took.
ImplicitStepResult OverdampedSystem::solved(const StepRule& rule, const Beads& from, const Beads& guess,
                                            const Beads& distant) {
  ImplicitStepResult result = implicit_step_->solve(rule, state_.positions[0], from, guess, distant);
  state_.products += result.products;
  is_solved_ = is_solved_ && result.is_solved;
  return result;
}

/// Of the positions at the start, by a step of no time.
void OverdampedSystem::find_velocities() {
  const Beads nowhere(radii_.size(), Vec3::Zero());
  const StepRule rule{.weight = 1, .span = 0, .time = time()};
  ImplicitStepResult result = solved(rule, nowhere, nowhere, state_.distant[0]);
  state_.smallest_gap = result.smallest_gap;
  state_.velocities[0] = std::move(result.velocities);
  state_.distant[0] = std::move(result.distant);
}

/// A step by n of Euler's implicit ones: u_k = u_k-1 + h/n v_k.
OverdampedSystem::Step OverdampedSystem::euler(int parts) {
  const double span = scene_.step / parts;
  Step step{Beads(radii_.size(), Vec3::Zero()), state_.velocities[0], state_.distant[0]};
  for (int k = 1; k <= parts; ++k) {
    const StepRule rule{.weight = 1, .span = span, .time = time() + k * span};
    const Beads guess = combined({{1, &step.displacements}, {span, &step.velocities}});
    ImplicitStepResult result = solved(rule, step.displacements, guess, step.distant);
    step = {std::move(result.displacements), std::move(result.velocities), std::move(result.distant)};
  }
  return step;
}

/// Third order by 1, 2 and 3 Euler steps: what is of h and h^2 in their errors cancels.
void OverdampedSystem::first_step() {
  const Step one = euler(1), two = euler(2), three = euler(3);
  const auto extrapolated = [&](Beads Step::*part) {
    return combined({{0.5, &(one.*part)}, {-4, &(two.*part)}, {4.5, &(three.*part)}});
  };
  accept({extrapolated(&Step::displacements), extrapolated(&Step::velocities), extrapolated(&Step::distant)});
}

/// In displacements from the positions now: coordinates may be large.
void OverdampedSystem::multistep() {
  const auto& [x, x1, x2] = state_.positions;
  const auto& [v, v1] = state_.velocities;
  const auto& [d, d1, d2] = state_.distant;
  const double h = scene_.step;
  const Beads u1 = combined({{1, &x1}, {-1, &x}}), u2 = combined({{1, &x2}, {-1, &x}});
  const StepRule rule{.weight = 11.0 / 6, .span = h, .time = time() + h};
  ImplicitStepResult result =
      solved(rule, combined({{-1.5, &u1}, {1.0 / 3, &u2}}),
             combined({{5, &u1}, {4 * h, &v}, {2 * h, &v1}}),  // cubic through x, x_1, v and v_1
             combined({{3, &d}, {-3, &d1}, {1, &d2}}));
  state_.smallest_gap = std::min(state_.smallest_gap, result.smallest_gap);
  accept({std::move(result.displacements), std::move(result.velocities), std::move(result.distant)});
}

void OverdampedSystem::accept(Step step) {
  const auto keep = [](auto& past, Beads now) {
    std::rotate(past.begin(), past.end() - 1, past.end());
    past[0] = std::move(now);
  };
  keep(state_.positions, combined({{1, &state_.positions[0]}, {1, &step.displacements}}));
  keep(state_.velocities, std::move(step.velocities));
  keep(state_.distant, std::move(step.distant));
  ++state_.steps_done;
  look_for_faults();
  if (!is_solved_ && !fault_) fault_ = {.kind = OverdampedFaultKind::unsolved, .step = state_.steps_done};
}

void OverdampedSystem::step() {
  if (fault_) {
    ++state_.steps_done;
    return;
  }
  state_.steps_done < 2 ? first_step() : multistep();
  for (const Vec3& v : state_.velocities[0]) state_.largest_speed = std::max(state_.largest_speed, v.norm());
}

/// All ranks have all beads and see the same.
void OverdampedSystem::look_for_faults() {
  const auto& [now, before, earlier] = state_.positions;
  const auto note = [&, &before = before](OverdampedFaultKind kind, std::size_t bead, int number,
                                          double value) {
    if (!fault_)
      fault_ = {kind, state_.steps_done, scene_.swimmers[bead / 3].id, number, before[bead], value};
  };
  for (std::size_t b = 0; b < now.size(); ++b) {
    const double moved = (now[b] - before[b]).norm() / radii_[b];
    const int number = static_cast<int>(b % 3) + 1;
    if (!std::isfinite(moved)) note(OverdampedFaultKind::not_finite, b, number, moved);
    if (moved > 1) note(OverdampedFaultKind::speed, b, number, moved);
    for (int a = 0; a < 3 && scene_.box; ++a) {
      const double beyond = std::max(-now[b][a], now[b][a] - scene_.box->lengths[a]);
      if (scene_.box->has_mirrors(a) && beyond > 0) note(OverdampedFaultKind::wall, b, number, beyond);
    }
    if (number == 3) continue;
    const double length =
        (now[b + 1] - now[b]).norm() / scene_.type_of(scene_.swimmers[b / 3]).springs[number - 1].rest_length;
    if (length > 2) note(OverdampedFaultKind::torn_arm, b, number, length);
  }
}

void OverdampedSystem::restore(OverdampedState state) {
  const auto is_whole = [&](const Beads& list) { return list.size() == radii_.size(); };
  if (!std::ranges::all_of(state.positions, is_whole) || !std::ranges::all_of(state.velocities, is_whole) ||
      !std::ranges::all_of(state.distant, is_whole))
    throw SolverError(
        fmt::format("the checkpoint is of another scene; take the other checkpoint, or begin without {}",
                    Setting::restart));
  state_ = std::move(state);
}

}  // namespace beadswim
