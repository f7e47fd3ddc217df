#include "implicit_step.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <optional>

namespace beadswim {
namespace {

/// Of the product's tolerance: up to which swimmers alone answer to what is left.
constexpr double solver_share = 0.3;

constexpr int most_products = 100;  ///< about one u*

/// Directions that are kept: memory of three vectors each.
constexpr std::size_t most_directions = 20;

/// Of the smallest radius: how far from u* swimmers alone may end, and how well u* is found where they do
/// not; how far all together may, and where not even that is come by.
constexpr double near_alone = 1e-3, found_alone = 1e-6, near_together = 1e-2, lost_together = 0.1;
constexpr int most_rounds_alone = 20, most_rounds = 10;

}  // namespace

ImplicitStep::ImplicitStep(const OverdampedScene& scene, std::span<const double> radii,
                           const MobilityProduct& mobility, const Communicator& communicator)
    : scene_(scene),
      radii_(radii),
      mobility_(mobility),
      communicator_(communicator),
      contact_scale_(scene),
      smallest_radius_(*std::ranges::min_element(radii)) {
  for (const SwimmerType& type : scene.types)
    for (const Spring& spring : type.springs) shortest_arm_ = std::min(shortest_arm_, spring.rest_length);
}

/// Over the smallest radius. As rank 0 has it, whatever ranks' processors: ranks decide alike.
double ImplicitStep::farthest_move(const Beads& from, const Beads& to) const {
  double farthest = 0;
  for (std::size_t b = 0; b < from.size(); ++b) {
    const double move = (to[b] - from[b]).norm() / smallest_radius_;
    if (!(move <= farthest)) farthest = move;  // NaN too
  }
  MPI_Bcast(&farthest, 1, MPI_DOUBLE, 0, communicator_.get());
  return farthest;
}

ImplicitStepResult ImplicitStep::solve(const StepRule& rule, const Beads& now, const Beads& from,
                                       const Beads& guess, const Beads& distant) const {
  const StepScene scene{scene_, radii_, contact_scale_, communicator_};
  Beads about = guess;
  ImplicitStepResult result;
  result.distant = distant;
  long products = 0;
  for (int round = 1;; ++round) {
    std::optional<ImplicitBalance> balance;
    for (int alone = 1;; ++alone) {
      balance.emplace(scene, rule, now, from, about, result.distant);
      Beads ends = balance->first_ends();
      const double move = farthest_move(about, ends);
      const bool is_near = !(move > (alone == 1 ? near_alone : found_alone));  // NaN is a fault, found later
      if (is_near || alone == most_rounds_alone) break;
      about = std::move(ends);
    }
    result = solve_about(*balance, about, now);
    products += result.products;
    const double move = farthest_move(about, result.displacements);
    // Arms that turn by `move` would stretch by move^2/l: under the tolerance of how far beads go.
    const double way = rule.span / rule.weight * flat(result.velocities).norm() / std::sqrt(3.0 * now.size());
    const double turn = std::sqrt(scene_.tolerance * shortest_arm_ * way) / smallest_radius_;
    if (!(move > std::min(near_together, turn)) || !result.is_solved) break;
    if (round == most_rounds) {
      result.is_solved = move < lost_together;
      break;
    }
    about = result.displacements;
  }
  result.products = products;
  return result;
}

ImplicitStepResult ImplicitStep::solve_about(const ImplicitBalance& balance, const Beads& about,
                                             const Beads& now) const {
  ImplicitStepResult result;
  Beads places = now;
  flat(places) += flat(about);
  const auto product = [&](const Beads& forces) {
    Beads velocities(forces.size());
    mobility_.apply(places, forces, velocities);
    ++result.products;
    return velocities;
  };
  struct Direction {
    Beads forces, velocities, left_side;  ///< p, mu p, p + D mu p; left sides orthonormal
  };
  std::deque<Direction> directions;
  Beads forces = balance.first_forces();
  Beads velocities = product(forces);
  Beads residual = balance.residual(forces, velocities);
  for (;;) {
    Beads own = balance.own_forces(residual);
    const Beads answer = balance.own_velocities(own);
    std::array<double, 2> norms{flat(answer).norm(), flat(velocities).norm()};
    MPI_Bcast(norms.data(), 2, MPI_DOUBLE, 0, communicator_.get());  // whatever ranks' processors
    const auto [missing, speed] = norms;
    const bool is_missing = missing > solver_share * scene_.tolerance * speed;  // NaN is a fault, found later
    if (!is_missing || result.products >= most_products) {
      result.is_solved = !is_missing;
      result.distant = velocities;
      flat(result.distant) -= flat(balance.own_velocities(forces));
      flat(velocities) += flat(answer);
      break;
    }
    Direction next{std::move(own), {}, {}};
    next.velocities = product(next.forces);
    next.left_side = balance.left_side(next.forces, next.velocities);
    for (const Direction& old : directions) {
      const double along = flat(old.left_side).dot(flat(next.left_side));
      flat(next.forces) -= along * flat(old.forces);
      flat(next.velocities) -= along * flat(old.velocities);
      flat(next.left_side) -= along * flat(old.left_side);
    }
    const double norm = flat(next.left_side).norm();
    for (Beads* part : {&next.forces, &next.velocities, &next.left_side}) flat(*part) /= norm;
    const double step = flat(next.left_side).dot(flat(residual));
    flat(forces) += step * flat(next.forces);
    flat(velocities) += step * flat(next.velocities);
    flat(residual) -= step * flat(next.left_side);
    directions.push_back(std::move(next));
    if (directions.size() > most_directions) directions.pop_front();
  }
  result.displacements = balance.displacements(velocities);
  result.smallest_gap = balance.smallest_gap(velocities);
  result.velocities = std::move(velocities);
  return result;
}

}  // namespace beadswim
