#include "implicit_step.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <optional>
#include <tuple>

#include "beadswim/core/rank_share.hpp"

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

/// The nine numbers of a swimmer, and all as one vector.
auto nine(const Beads& beads, std::size_t swimmer) {
  return Eigen::Map<const Vector9>(beads[3 * swimmer].data());
}
auto nine(Beads& beads, std::size_t swimmer) {
  return Eigen::Map<Vector9>(beads[3 * swimmer].data());
}
auto flat(const Beads& beads) {
  return Eigen::Map<const Eigen::VectorXd>(beads[0].data(), 3 * std::ssize(beads));
}
auto flat(Beads& beads) {
  return Eigen::Map<Eigen::VectorXd>(beads[0].data(), 3 * std::ssize(beads));
}

Beads none(std::size_t count) {
  return Beads(count, Vec3::Zero());
}

bool is_within_swimmer(const Contact& c) {
  return c.first / 3 == c.second / 3 && !c.is_image;
}

/// How much displacements widen the gap. A bead's own image behind a wall moves as much the other way.
double widening(const Contact& c, const Beads& displacements) {
  if (c.first == c.second) return 2 * c.normal.dot(displacements[c.first]);
  return c.normal.dot(displacements[c.first] - displacements[c.second]);
}

void push(const Contact& c, double force, Beads& forces) {
  forces[c.first] += force * c.normal;
  if (c.second != c.first) forces[c.second] -= force * c.normal;
}

}  // namespace

/// The linear system of a step about u*, each swimmer's part kept by the rank that it is of.
class ImplicitStep::Balance {
 public:
  /// Contacts and forces about `about`.
  Balance(const ImplicitStep& step, const StepRule& rule, const Beads& now, const Beads& from,
          const Beads& about, const Beads& distant)
      : communicator_(step.communicator_), rule_(rule), from_(from), about_(about) {
    const auto& scene = step.scene_;
    std::tie(first_, last_) =
        rank_share(std::ssize(scene.swimmers), communicator_.rank(), communicator_.size());
    Beads places = now;
    flat(places) += flat(about);
    for (const Contact& contact : find_contacts(step.contact_scale_, scene.box, step.radii_, places))
      (is_within_swimmer(contact) ? within_ : between_).push_back(contact);
    Beads others = none(now.size());
    std::vector<Matrix9> stiffness(last_ - first_, Matrix9::Zero());
    for (const Contact& c : between_) {
      push(c, c.law.force, others);
      // Twice that of the contact, as if the other bead, or its own image, moved as much the other way.
      const double share = c.first == c.second ? 1 : 2;
      for (const int bead : {c.first, c.second})
        if (const std::size_t s = bead / 3; s >= first_ && s < last_)
          stiffness[s - first_].block<3, 3>(3 * (bead % 3), 3 * (bead % 3)) +=
              share * c.law.stiffness * c.normal * c.normal.transpose();
    }
    parts_.reserve(last_ - first_);
    for (std::size_t s = first_; s < last_; ++s)
      parts_.push_back(implicit_swimmer(rule, {.type = scene.type_of(s),
                                               .initial_axis = scene.swimmers[s].axis,
                                               .now = nine(now, s),
                                               .from = nine(from, s),
                                               .about = nine(about, s),
                                               .distant = nine(distant, s),
                                               .others = nine(others, s),
                                               .others_stiffness = stiffness[s - first_],
                                               .viscosity = scene.viscosity,
                                               .scale = step.contact_scale_}));
  }

  /// u if the flow that carries each swimmer does not change.
  Beads first_ends() const {
    return of_each([&](std::size_t, const ImplicitSwimmer& part) { return part.end; });
  }

  /// F if the flow that carries each swimmer does not change.
  Beads first_forces() const {
    return of_each([&](std::size_t, const ImplicitSwimmer& part) { return part.forces; });
  }

  /// u = (r + h v)/w.
  Beads displacements(const Beads& velocities) const {
    Beads u = from_;
    flat(u) = (flat(from_) + rule_.span * flat(velocities)) / rule_.weight;
    return u;
  }

  /// drive - D v - F.
  Beads residual(const Beads& forces, const Beads& velocities) const {
    const Beads beyond = beyond_about(velocities);
    Beads contacts = none(forces.size());
    for (const Contact& c : between_) push(c, c.law.force - c.law.stiffness * widening(c, beyond), contacts);
    return of_each([&](std::size_t s, const ImplicitSwimmer& part) -> Vector9 {
      return part.drive + nine(contacts, s) - part.resistance * nine(velocities, s) - nine(forces, s);
    });
  }

  /// F + D v.
  Beads left_side(const Beads& forces, const Beads& velocities) const {
    Beads contacts = none(forces.size());
    const double compliance = rule_.span / rule_.weight;
    for (const Contact& c : between_)
      push(c, compliance * c.law.stiffness * widening(c, velocities), contacts);
    return of_each([&](std::size_t s, const ImplicitSwimmer& part) -> Vector9 {
      return nine(forces, s) + part.resistance * nine(velocities, s) + nine(contacts, s);
    });
  }

  /// p of (1 + D mu_own) p = residual.
  Beads own_forces(const Beads& residual) const {
    return of_each([&](std::size_t s, const ImplicitSwimmer& part) -> Vector9 {
      return part.balance.solve(nine(residual, s));
    });
  }

  /// mu_own F.
  Beads own_velocities(const Beads& forces) const {
    return of_each([&](std::size_t s, const ImplicitSwimmer& part) -> Vector9 {
      return part.mobility * nine(forces, s);
    });
  }

  /// Of contacts that still are ones at the end.
  double smallest_gap(const Beads& velocities) const {
    const Beads beyond = beyond_about(velocities);
    double smallest = std::numeric_limits<double>::infinity();
    for (const auto* contacts : {&within_, &between_})
      for (const Contact& c : *contacts) {
        const double gap = c.gap + widening(c, beyond);
        if (gap < c.reach)  // to the wall, not to the image behind it
          smallest = std::min(smallest, c.first == c.second ? gap / 2 : gap);
      }
    return smallest;
  }

 private:
  /// What value(swimmer, part) says of each, from all ranks.
  template <class Value>
  Beads of_each(const Value& value) const {
    Beads beads(from_.size());
    for (std::size_t s = first_; s < last_; ++s) nine(beads, s) = value(s, parts_[s - first_]);
    share(beads);
    return beads;
  }

  void share(Beads& beads) const {
    const int ranks = communicator_.size();
    if (ranks == 1) return;
    std::vector<int> counts, starts;
    for (int r = 0; r < ranks; ++r) {
      const auto [first, last] = rank_share(std::ssize(beads) / 3, r, ranks);
      counts.push_back(static_cast<int>(9 * (last - first)));
      starts.push_back(static_cast<int>(9 * first));
    }
    MPI_Allgatherv(MPI_IN_PLACE, 0, MPI_DATATYPE_NULL, beads[0].data(), counts.data(), starts.data(),
                   MPI_DOUBLE, communicator_.get());
  }

  /// u - u*.
  Beads beyond_about(const Beads& velocities) const {
    Beads beyond = displacements(velocities);
    flat(beyond) -= flat(about_);
    return beyond;
  }

  const Communicator& communicator_;
  const StepRule& rule_;
  const Beads &from_, &about_;
  std::size_t first_ = 0, last_ = 0;  ///< swimmers of this rank
  std::vector<ImplicitSwimmer> parts_;
  std::vector<Contact> within_, between_;  ///< swimmers
};

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
  Beads about = guess;
  ImplicitStepResult result;
  result.distant = distant;
  long products = 0;
  for (int round = 1;; ++round) {
    std::optional<Balance> balance;
    for (int alone = 1;; ++alone) {
      balance.emplace(*this, rule, now, from, about, result.distant);
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

ImplicitStepResult ImplicitStep::solve_about(const Balance& balance, const Beads& about,
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
