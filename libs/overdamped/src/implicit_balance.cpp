#include "implicit_balance.hpp"

#include <algorithm>
#include <limits>
#include <tuple>

#include "beadswim/core/rank_share.hpp"
#include "beadswim/mobility/step_mobility.hpp"

namespace beadswim {
namespace {

Beads zero_vectors(std::size_t count) {
  return Beads(count, Vec3::Zero());
}

/// Returns the index of the swimmer that a bead belongs to.
std::size_t swimmer_of(std::span<const BeadRange> bead_ranges, std::size_t bead) {
  return std::ranges::upper_bound(bead_ranges, bead, {}, &BeadRange::first) - bead_ranges.begin() - 1;
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
                                 const StepHistory& history, const Beads& expansion_point,
                                 const Beads& distant)
    : communicator_(step.communicator),
      rule_(rule),
      history_(history.displacements),
      expansion_point_(expansion_point),
      bead_ranges_(step.bead_ranges) {
  const auto& scene = step.scene;
  std::tie(first_, last_) =
      rank_share(std::ssize(scene.swimmers), communicator_.rank(), communicator_.size());
  Beads places = start;
  flat(places) += flat(expansion_point);
  const auto is_within_swimmer = [&](const Contact& c) {
    return swimmer_of(bead_ranges_, c.first) == swimmer_of(bead_ranges_, c.second) && !c.is_image;
  };
  for (const Contact& contact : find_contacts(
           step.contact_scale, {.box = scene.box, .half_space = scene.half_space}, step.radii, places))
    (is_within_swimmer(contact) ? internal_contacts_ : external_contacts_).push_back(contact);
  Beads external_forces = zero_vectors(start.size());
  std::vector<Eigen::MatrixXd> stiffness(last_ - first_);  // empty without contacts
  for (const Contact& c : external_contacts_) {
    add_contact_force(c, c.law.force, external_forces);
    // Each bead of a contact gets twice its stiffness in the matrix of its swimmer. This assumes that the
    // other bead, or the mirror image, moves opposite to it by the same distance. If a bead is in contact
    // with its own image, the loop reaches it twice and adds the stiffness once each time.
    const double share = c.first == c.second ? 1 : 2;
    for (const int bead : {c.first, c.second}) {
      const std::size_t s = swimmer_of(bead_ranges_, bead);
      if (s < first_ || s >= last_) continue;
      const auto [begin, end] = bead_ranges_[s];
      Eigen::MatrixXd& block = stiffness[s - first_];
      if (block.size() == 0) block = Eigen::MatrixXd::Zero(3 * (end - begin), 3 * (end - begin));
      block.block<3, 3>(3 * (bead - begin), 3 * (bead - begin)) +=
          share * c.law.stiffness * c.normal * c.normal.transpose();
    }
  }
  Beads inertia = zero_vectors(start.size()), inertia_forces = inertia;
  double kappa = 0;
  if (scene.memory && rule.span > 0) {
    kappa = step_wavenumber(scene.viscosity / scene.memory->density * rule.span);
    for (std::size_t b = 0; b < start.size(); ++b) {
      inertia[b].setConstant(step.excess_masses[b] * rule.weight / rule.span);
      inertia_forces[b] = step.excess_masses[b] / rule.span * history.velocities[b];
    }
  }
  parts_.reserve(last_ - first_);
  const auto add_part = [&]<int Size>(std::integral_constant<int, Size>, std::size_t s) {
    const BeadRange& range = bead_ranges_[s];
    parts_.push_back(implicit_swimmer<Size>(
        rule, {.type = scene.type_of(scene.swimmers[s]),
               .initial_orientation = scene.swimmers[s].orientation,
               .start = swimmer_vector<Size>(start, range),
               .history = swimmer_vector<Size>(history_, range),
               .expansion_point = swimmer_vector<Size>(expansion_point, range),
               .distant = swimmer_vector<Size>(distant, range),
               .inertia = swimmer_vector<Size>(inertia, range),
               .inertia_forces = swimmer_vector<Size>(inertia_forces, range),
               .external_forces = swimmer_vector<Size>(external_forces, range),
               .external_stiffness = stiffness[s - first_],
               .viscosity = scene.viscosity,
               .step_wavenumber = kappa,
               .contact_strength = step.contact_scale.strength,
               .own_cutoff_per_radius = step.contact_scale.own_cutoff_per_radius[range.first]}));
  };
  for (std::size_t s = first_; s < last_; ++s) {
    if (bead_ranges_[s].last - bead_ranges_[s].first == 3) {
      add_part(std::integral_constant<int, size_of_three_beads>{}, s);
    } else {
      add_part(std::integral_constant<int, Eigen::Dynamic>{}, s);
    }
  }
}

/// Evaluates value(range, part) for each swimmer of this rank, where `range` are its beads and `part` is its
/// linear system. Returns
/// the values of the swimmers of all ranks. Collective.
template <class Value>
Beads ImplicitBalance::gather(const Value& value) const {
  Beads beads(history_.size());
  for (std::size_t s = first_; s < last_; ++s) {
    const BeadRange& range = bead_ranges_[s];
    std::visit(
        [&]<int Size>(const ImplicitSwimmer<Size>& part) {
          swimmer_vector<Size>(beads, range) = value(range, part);
        },
        parts_[s - first_]);
  }
  share(beads);
  return beads;
}

void ImplicitBalance::share(Beads& beads) const {
  const int ranks = communicator_.size();
  if (ranks == 1) return;
  std::vector<int> counts, starts;
  for (int r = 0; r < ranks; ++r) {
    const auto [first, last] = rank_share(std::ssize(bead_ranges_), r, ranks);
    const std::size_t begin = first < std::ssize(bead_ranges_) ? bead_ranges_[first].first : beads.size();
    const std::size_t end = first < last ? bead_ranges_[last - 1].last : begin;
    counts.push_back(static_cast<int>(3 * (end - begin)));
    starts.push_back(static_cast<int>(3 * begin));
  }
  MPI_Allgatherv(MPI_IN_PLACE, 0, MPI_DATATYPE_NULL, beads[0].data(), counts.data(), starts.data(),
                 MPI_DOUBLE, communicator_.get());
}

Beads ImplicitBalance::initial_displacements() const {
  return gather([&](const BeadRange&, const auto& part) { return part.end; });
}

Beads ImplicitBalance::initial_forces() const {
  return gather([&](const BeadRange&, const auto& part) { return part.forces; });
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
  return gather([&]<int Size>(const BeadRange& range,
                              const ImplicitSwimmer<Size>& part) -> SwimmerVector<Size> {
    return part.drive + swimmer_vector<Size>(contacts, range) -
           part.resistance * swimmer_vector<Size>(velocities, range) - swimmer_vector<Size>(forces, range);
  });
}

Beads ImplicitBalance::left_hand_side(const Beads& forces, const Beads& velocities) const {
  Beads contacts = zero_vectors(forces.size());
  const double compliance = rule_.span / rule_.weight;
  for (const Contact& c : external_contacts_)
    add_contact_force(c, compliance * c.law.stiffness * gap_change(c, velocities), contacts);
  return gather([&]<int Size>(const BeadRange& range,
                              const ImplicitSwimmer<Size>& part) -> SwimmerVector<Size> {
    return swimmer_vector<Size>(forces, range) + part.resistance * swimmer_vector<Size>(velocities, range) +
           swimmer_vector<Size>(contacts, range);
  });
}

Beads ImplicitBalance::own_forces(const Beads& residual) const {
  return gather(
      [&]<int Size>(const BeadRange& range, const ImplicitSwimmer<Size>& part) -> SwimmerVector<Size> {
        return part.balance.solve(swimmer_vector<Size>(residual, range));
      });
}

Beads ImplicitBalance::own_velocities(const Beads& forces) const {
  return gather(
      [&]<int Size>(const BeadRange& range, const ImplicitSwimmer<Size>& part) -> SwimmerVector<Size> {
        return part.mobility * swimmer_vector<Size>(forces, range);
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
