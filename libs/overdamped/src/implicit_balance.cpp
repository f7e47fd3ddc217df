#include "implicit_balance.hpp"

#include <algorithm>
#include <limits>
#include <tuple>

#include "beadswim/core/rank_share.hpp"

namespace beadswim {
namespace {

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

ImplicitBalance::ImplicitBalance(const StepScene& step, const StepRule& rule, const Beads& now,
                                 const Beads& from, const Beads& about, const Beads& distant)
    : communicator_(step.communicator), rule_(rule), from_(from), about_(about) {
  const auto& scene = step.scene;
  std::tie(first_, last_) =
      rank_share(std::ssize(scene.swimmers), communicator_.rank(), communicator_.size());
  Beads places = now;
  flat(places) += flat(about);
  for (const Contact& contact : find_contacts(step.contact_scale, scene.box, step.radii, places))
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
    parts_.push_back(implicit_swimmer(rule, {.type = scene.type_of(scene.swimmers[s]),
                                             .initial_axis = scene.swimmers[s].axis,
                                             .now = nine(now, s),
                                             .from = nine(from, s),
                                             .about = nine(about, s),
                                             .distant = nine(distant, s),
                                             .others = nine(others, s),
                                             .others_stiffness = stiffness[s - first_],
                                             .viscosity = scene.viscosity,
                                             .scale = step.contact_scale}));
}

/// What value(swimmer, part) says of each, from all ranks.
template <class Value>
Beads ImplicitBalance::of_each(const Value& value) const {
  Beads beads(from_.size());
  for (std::size_t s = first_; s < last_; ++s) nine(beads, s) = value(s, parts_[s - first_]);
  share(beads);
  return beads;
}

void ImplicitBalance::share(Beads& beads) const {
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

Beads ImplicitBalance::first_ends() const {
  return of_each([&](std::size_t, const ImplicitSwimmer& part) { return part.end; });
}

Beads ImplicitBalance::first_forces() const {
  return of_each([&](std::size_t, const ImplicitSwimmer& part) { return part.forces; });
}

Beads ImplicitBalance::displacements(const Beads& velocities) const {
  Beads u = from_;
  flat(u) = (flat(from_) + rule_.span * flat(velocities)) / rule_.weight;
  return u;
}

/// u - u*.
Beads ImplicitBalance::beyond_about(const Beads& velocities) const {
  Beads beyond = displacements(velocities);
  flat(beyond) -= flat(about_);
  return beyond;
}

Beads ImplicitBalance::residual(const Beads& forces, const Beads& velocities) const {
  const Beads beyond = beyond_about(velocities);
  Beads contacts = none(forces.size());
  for (const Contact& c : between_) push(c, c.law.force - c.law.stiffness * widening(c, beyond), contacts);
  return of_each([&](std::size_t s, const ImplicitSwimmer& part) -> Vector9 {
    return part.drive + nine(contacts, s) - part.resistance * nine(velocities, s) - nine(forces, s);
  });
}

Beads ImplicitBalance::left_side(const Beads& forces, const Beads& velocities) const {
  Beads contacts = none(forces.size());
  const double compliance = rule_.span / rule_.weight;
  for (const Contact& c : between_) push(c, compliance * c.law.stiffness * widening(c, velocities), contacts);
  return of_each([&](std::size_t s, const ImplicitSwimmer& part) -> Vector9 {
    return nine(forces, s) + part.resistance * nine(velocities, s) + nine(contacts, s);
  });
}

Beads ImplicitBalance::own_forces(const Beads& residual) const {
  return of_each([&](std::size_t s, const ImplicitSwimmer& part) -> Vector9 {
    return part.balance.solve(nine(residual, s));
  });
}

Beads ImplicitBalance::own_velocities(const Beads& forces) const {
  return of_each(
      [&](std::size_t s, const ImplicitSwimmer& part) -> Vector9 { return part.mobility * nine(forces, s); });
}

double ImplicitBalance::smallest_gap(const Beads& velocities) const {
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

}  // namespace beadswim
