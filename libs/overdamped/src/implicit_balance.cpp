#include "implicit_balance.hpp"

#include <algorithm>
#include <limits>
#include <tuple>

#include "beadswim/core/rank_share.hpp"

namespace beadswim {
namespace {

Beads zero_vectors(std::size_t count) {
  return Beads(count, Vec3::Zero());
}

bool is_within_swimmer(const Contact& c) {
  return c.first / 3 == c.second / 3 && !c.is_image;
}

/// Returns the change of the gap of a contact that displacements of the beads cause. The mirror image of a
/// bead moves opposite to the bead along the normal of the wall.
double gap_change(const Contact& c, const Beads& displacements) {
  if (c.first == c.second) return 2 * c.normal.dot(displacements[c.first]);
  return c.normal.dot(displacements[c.first] - displacements[c.second]);
}

void add_contact_force(const Contact& c, double force, Beads& forces) {
  forces[c.first] += force * c.normal;
  if (c.second != c.first) forces[c.second] -= force * c.normal;
}

}  // namespace

ImplicitBalance::ImplicitBalance(const StepScene& step, const StepRule& rule, const Beads& start,
                                 const Beads& history, const Beads& expansion_point, const Beads& distant)
    : communicator_(step.communicator), rule_(rule), history_(history), expansion_point_(expansion_point) {
  const auto& scene = step.scene;
  std::tie(first_, last_) =
      rank_share(std::ssize(scene.swimmers), communicator_.rank(), communicator_.size());
  Beads places = start;
  flat(places) += flat(expansion_point);
  for (const Contact& contact : find_contacts(step.contact_scale, scene.box, step.radii, places))
    (is_within_swimmer(contact) ? internal_contacts_ : external_contacts_).push_back(contact);
  Beads external_forces = zero_vectors(start.size());
  std::vector<Matrix9> stiffness(last_ - first_, Matrix9::Zero());
  for (const Contact& c : external_contacts_) {
    add_contact_force(c, c.law.force, external_forces);
    // Each bead of a contact gets twice its stiffness in the matrix of its swimmer. This assumes that the
    // other bead, or the mirror image, moves opposite to it by the same distance. If a bead is in contact
    // with its own image, the loop reaches it twice and adds the stiffness once each time.
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
                                             .start = swimmer_vector(start, s),
                                             .history = swimmer_vector(history, s),
                                             .expansion_point = swimmer_vector(expansion_point, s),
                                             .distant = swimmer_vector(distant, s),
                                             .external_forces = swimmer_vector(external_forces, s),
                                             .external_stiffness = stiffness[s - first_],
                                             .viscosity = scene.viscosity,
                                             .scale = step.contact_scale}));
}

/// Evaluates value(swimmer, part) for each swimmer of this rank, where `part` is its linear system. Returns
/// the values of the swimmers of all ranks. Collective.
template <class Value>
Beads ImplicitBalance::gather(const Value& value) const {
  Beads beads(history_.size());
  for (std::size_t s = first_; s < last_; ++s) swimmer_vector(beads, s) = value(s, parts_[s - first_]);
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

Beads ImplicitBalance::initial_displacements() const {
  return gather([&](std::size_t, const ImplicitSwimmer& part) { return part.end; });
}

Beads ImplicitBalance::initial_forces() const {
  return gather([&](std::size_t, const ImplicitSwimmer& part) { return part.forces; });
}

Beads ImplicitBalance::displacements(const Beads& velocities) const {
  Beads u = history_;
  flat(u) = (flat(history_) + rule_.span * flat(velocities)) / rule_.weight;
  return u;
}

/// Returns u - u*: the displacements u of the beads at the end of a step with these velocities, minus the
/// expansion point u*.
Beads ImplicitBalance::displacements_from_expansion(const Beads& velocities) const {
  Beads beyond = displacements(velocities);
  flat(beyond) -= flat(expansion_point_);
  return beyond;
}

Beads ImplicitBalance::residual(const Beads& forces, const Beads& velocities) const {
  const Beads beyond = displacements_from_expansion(velocities);
  Beads contacts = zero_vectors(forces.size());
  for (const Contact& c : external_contacts_)
    add_contact_force(c, c.law.force - c.law.stiffness * gap_change(c, beyond), contacts);
  return gather([&](std::size_t s, const ImplicitSwimmer& part) -> Vector9 {
    return part.drive + swimmer_vector(contacts, s) - part.resistance * swimmer_vector(velocities, s) -
           swimmer_vector(forces, s);
  });
}

Beads ImplicitBalance::left_hand_side(const Beads& forces, const Beads& velocities) const {
  Beads contacts = zero_vectors(forces.size());
  const double compliance = rule_.span / rule_.weight;
  for (const Contact& c : external_contacts_)
    add_contact_force(c, compliance * c.law.stiffness * gap_change(c, velocities), contacts);
  return gather([&](std::size_t s, const ImplicitSwimmer& part) -> Vector9 {
    return swimmer_vector(forces, s) + part.resistance * swimmer_vector(velocities, s) +
           swimmer_vector(contacts, s);
  });
}

Beads ImplicitBalance::own_forces(const Beads& residual) const {
  return gather([&](std::size_t s, const ImplicitSwimmer& part) -> Vector9 {
    return part.balance.solve(swimmer_vector(residual, s));
  });
}

Beads ImplicitBalance::own_velocities(const Beads& forces) const {
  return gather([&](std::size_t s, const ImplicitSwimmer& part) -> Vector9 {
    return part.mobility * swimmer_vector(forces, s);
  });
}

double ImplicitBalance::smallest_gap(const Beads& velocities) const {
  const Beads beyond = displacements_from_expansion(velocities);
  double smallest = std::numeric_limits<double>::infinity();
  for (const auto* contacts : {&internal_contacts_, &external_contacts_})
    for (const Contact& c : *contacts) {
      const double gap = c.gap + gap_change(c, beyond);
      if (gap < c.cutoff)  // reported gap: bead to wall, half of bead to image
        smallest = std::min(smallest, c.first == c.second ? gap / 2 : gap);
    }
  return smallest;
}

}  // namespace beadswim
