#include "implicit_step.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <optional>

namespace beadswim {
namespace {

/// Largest accepted norm of the final correction of the velocities, divided by the product of the norm of the
/// velocities and the tolerance of the mobility product.
constexpr double residual_share = 0.3;

constexpr int max_products = 100;  ///< largest number of mobility products per expansion point

/// Number of search directions that the GCR method stores, each with three vectors per bead.
constexpr std::size_t max_directions = 20;

/// Limits of the distance of a bead between the expansion point u* and the solution u, divided by the
/// smallest radius.
///   own_move_limit        for each swimmer solved alone, with the initial guess as u*
///   own_move_tolerance    if own_move_limit is exceeded, u* is iterated until it changes by less than this
///   joint_move_tolerance  for all swimmers solved together; if exceeded, u* is moved to the solution
///   joint_move_limit      largest distance that counts as converged after max_iterations
/// The two joint limits are also divided by the smallest cutoff of contacts (ContactScale), because the
/// contact force changes over this distance.
constexpr double own_move_limit = 1e-3, own_move_tolerance = 1e-6, joint_move_tolerance = 0.05,
                 joint_move_limit = 0.5;
constexpr int max_own_iterations = 20, max_iterations = 10;

/// Returns the accepted relative error of the velocities of a step, in which noise has its own error.
double tolerance_of(const StepScene& scene, const StepStart& step) {
  return step.noise ? std::max(scene.scene.tolerance, scene.scene.noise_tolerance) : scene.scene.tolerance;
}

double shortest_arm(std::span<const SwimmerType> types) {
  double shortest = std::numeric_limits<double>::infinity();
  for (const SwimmerType& type : types)
    for (const Bond& bond : type.bonds) shortest = std::min(shortest, bond.rest_length);
  return shortest;
}

/// Returns the largest distance of one bead between the lists `from` and `to`, divided by the smallest
/// radius. All ranks use the value of rank 0, because roundoff may differ between processors and all ranks
/// must make the same decision.
double largest_move(const StepScene& scene, const Beads& from, const Beads& to) {
  double farthest = 0;
  for (std::size_t b = 0; b < from.size(); ++b) {
    const double move = (to[b] - from[b]).norm() / scene.smallest_radius;
    if (!(move <= farthest)) farthest = move;  // true also if move is NaN
  }
  MPI_Bcast(&farthest, 1, MPI_DOUBLE, 0, scene.communicator.get());
  return farthest;
}

ImplicitStepResult solve_linearised(const StepScene& scene, Mobility& mobility, const StepStart& step,
                                    const ImplicitBalance& balance) {
  ImplicitStepResult result;
  Beads places = step.positions;
  flat(places) += flat(step.noise ? step.noise->mobility_at : step.expansion_point);
  mobility.set_positions(places);
  double excess_share = 0;  // sum m'/(rho V)
  for (const double mass : scene.excess_masses) excess_share += mass / scene.fluid_mass;
  // The mean flow u_0 depends on the velocities y + u_0 themselves: u_0 = u_0(y)/(1 + sum m'/(rho V)).
  const auto product = [&](const Beads& forces, FlowPart part, const MomentGuess& guess) {
    Beads velocities(forces.size());
    result.work.add(mobility.apply(forces, velocities, part, guess));
    if (const Vec3 flow = mean_flow(scene, velocities) / (1 + excess_share); !flow.isZero(0))
      for (Vec3& v : velocities) v += flow;
    return velocities;
  };
  const auto present_moments = [&] {
    const std::span<const double> moments = mobility.moments();
    return std::vector(moments.begin(), moments.end());
  };
  struct Direction {
    Beads forces, velocities, left_hand_side;  ///< p, mu p and p + D mu p; the p + D mu p are orthonormal
    std::vector<double> moments;               ///< by the forces p
  };
  std::deque<Direction> directions;
  Beads forces = balance.initial_forces();
  Beads velocities = product(forces, FlowPart::all, {.moments = step.moments});
  if (step.noise) flat(velocities) += flat(step.noise->velocities);
  result.moments = present_moments();
  Beads residual = balance.residual(forces, velocities);
  for (;;) {
    Beads own = balance.own_forces(residual);
    const Beads answer = balance.own_velocities(own);
    std::array<double, 2> norms{flat(answer).norm(), flat(velocities).norm()};
    MPI_Bcast(norms.data(), 2, MPI_DOUBLE, 0,
              scene.communicator.get());  // all ranks must make the same decision
    const auto [missing, speed] = norms;
    // False if a norm is NaN, which check_faults() reports later.
    const bool is_missing = missing > residual_share * tolerance_of(scene, step) * speed;
    if (!is_missing || result.work.products >= max_products) {
      result.is_converged = !is_missing && result.work.is_converged;
      result.distant = velocities;
      flat(result.distant) -= flat(balance.own_velocities(forces));
      flat(velocities) += flat(answer);
      flat(forces) += flat(own);
      const std::size_t per_bead = result.moments.size() / own.size();
      for (std::size_t b = 0; b < own.size() && per_bead > 0; ++b)
        Vec3::Map(&result.moments[per_bead * b]) += own[b];
      break;
    }
    Direction next{.forces = std::move(own), .velocities = {}, .left_hand_side = {}, .moments = {}};
    // The error of a correction matters relative to all velocities.
    constexpr double largest_error = 0.03;
    const double tolerance_factor = std::clamp(residual_share * speed / missing, 1.0,
                                               std::max(1.0, largest_error / scene.scene.tolerance));
    next.velocities =
        product(next.forces, FlowPart::forces, {.moments = {}, .tolerance_factor = tolerance_factor});
    next.moments = present_moments();
    next.left_hand_side = balance.left_hand_side(next.forces, next.velocities);
    for (const Direction& old : directions) {
      const double along = flat(old.left_hand_side).dot(flat(next.left_hand_side));
      flat(next.forces) -= along * flat(old.forces);
      flat(next.velocities) -= along * flat(old.velocities);
      flat(next.left_hand_side) -= along * flat(old.left_hand_side);
      flat(next.moments) -= along * flat(old.moments);
    }
    const double norm = flat(next.left_hand_side).norm();
    for (Beads* part : {&next.forces, &next.velocities, &next.left_hand_side}) flat(*part) /= norm;
    flat(next.moments) /= norm;
    const double along = flat(next.left_hand_side).dot(flat(residual));
    flat(forces) += along * flat(next.forces);
    flat(velocities) += along * flat(next.velocities);
    flat(residual) -= along * flat(next.left_hand_side);
    flat(result.moments) += along * flat(next.moments);
    directions.push_back(std::move(next));
    if (directions.size() > max_directions) directions.pop_front();
  }
  result.displacements = balance.displacements(velocities);
  result.smallest_gap = balance.smallest_gap(velocities);
  result.velocities = std::move(velocities);
  result.forces = std::move(forces);
  return result;
}

}  // namespace

ImplicitStepResult solve_implicit_step(const StepScene& scene, Mobility& mobility, const StepStart& step) {
  Beads expansion_point = step.expansion_point;
  ImplicitStepResult result{.distant = step.distant};
  const StepStart at{step.rule,      step.positions, step.history, expansion_point,
                     result.distant, step.noise,     step.moments};
  ProductWork work;
  for (int round = 1;; ++round) {
    std::optional<ImplicitBalance> balance;
    for (int alone = 1;; ++alone) {
      balance.emplace(scene, at);
      Beads ends = balance->initial_displacements();
      const double move = largest_move(scene, expansion_point, ends);
      // True also if `move` is NaN, which check_faults() reports later.
      const bool is_near = !(move > (alone == 1 ? own_move_limit : own_move_tolerance));
      if (is_near || alone == max_own_iterations) break;
      expansion_point = std::move(ends);
    }
    result = solve_linearised(scene, mobility, at, *balance);
    work.add(result.work);
    const double move = largest_move(scene, expansion_point, result.displacements);
    // If an arm of rest length l rotates, the linearised forces stretch it by about move^2/l. This error must
    // be below the tolerance times `way`, the root mean square displacement of the beads. `turn` is the
    // largest `move` that satisfies this.
    const double way = step.rule.span / step.rule.weight * flat(result.velocities).norm() /
                       std::sqrt(3.0 * step.positions.size());
    const double turn =
        std::sqrt(tolerance_of(scene, step) * shortest_arm(scene.scene.types) * way) / scene.smallest_radius;
    const double cutoff = scene.contact_scale.min_cutoff_per_radius;
    if (!(move > std::min(joint_move_tolerance * cutoff, turn)) || !result.is_converged) break;
    if (round == max_iterations) {
      result.is_converged = move < joint_move_limit * cutoff;
      break;
    }
    expansion_point = result.displacements;
  }
  result.work = work;
  return result;
}

Vec3 excess_momentum(const StepScene& scene, const Beads& velocities) {
  Vec3 momentum = Vec3::Zero();
  for (std::size_t b = 0; b < scene.excess_masses.size(); ++b)
    momentum += scene.excess_masses[b] * velocities[b];
  return momentum;
}

Vec3 mean_flow(const StepScene& scene, const Beads& velocities) {
  if (!scene.scene.memory) return Vec3::Zero();
  Vec3 flow = -excess_momentum(scene, velocities) / scene.fluid_mass;
  for (int a = 0; a < 3; ++a)
    if (scene.scene.domain.box->has_mirrors(a)) flow[a] = 0;
  return flow;
}

}  // namespace beadswim
