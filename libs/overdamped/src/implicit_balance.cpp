#include "implicit_balance.hpp"

#include <algorithm>
#include <limits>
#include <tuple>

#include "beadswim/core/communicator.hpp"

namespace beadswim {
namespace {

Beads zero_vectors(std::size_t count) {
  return Beads(count, Vec3::Zero());
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

ImplicitBalance::ImplicitBalance(const StepScene& scene, const StepStart& step) : scene_(scene), step_(step) {
  const auto& ranges = scene.bead_ranges;
  const std::vector<int>& swimmer_of = scene.contact_scale.swimmer;
  std::tie(first_, last_) =
      rank_share(std::ssize(ranges), scene.communicator.rank(), scene.communicator.size());
  Beads places = step.positions;
  flat(places) += flat(step.expansion_point);
  for (const Contact& contact : find_contacts(scene.contact_scale, scene.scene.domain, scene.radii, places))
    (contact.is_own ? own_contacts_ : external_contacts_).push_back(contact);
  // The order of the cells, in which contacts are found, must not affect sums of forces.
  std::ranges::sort(own_contacts_, {}, [](const Contact& c) { return std::minmax({c.first, c.second}); });
  Beads external_forces = zero_vectors(places.size());
  std::vector<Eigen::MatrixXd> stiffness(last_ - first_);  // empty without contacts
  for (const Contact& c : external_contacts_) {
    add_contact_force(c, c.law.force, external_forces);
    // Each bead of a contact gets twice its stiffness in the matrix of its swimmer. This assumes that the
    // other bead, or the mirror image, moves opposite to it by the same distance. If a bead is in contact
    // with its own image, the loop reaches it twice and adds the stiffness once each time.
    const double share = c.first == c.second ? 1 : 2;
    for (const int bead : {c.first, c.second}) {
      const auto s = static_cast<std::size_t>(swimmer_of[bead]);
      if (s < first_ || s >= last_) continue;
      const auto [begin, end] = ranges[s];
      Eigen::MatrixXd& block = stiffness[s - first_];
      if (block.size() == 0) block = Eigen::MatrixXd::Zero(3 * (end - begin), 3 * (end - begin));
      block.block<3, 3>(3 * (bead - begin), 3 * (bead - begin)) +=
          share * c.law.stiffness * c.normal * c.normal.transpose();
    }
  }
  parts_.reserve(last_ - first_);
  for (std::size_t s = first_; s < last_; ++s) {
    const auto first_contact = [&](std::size_t bead) {
      const auto lower_bead = [](const Contact& c) { return std::min(c.first, c.second); };
      return std::ranges::lower_bound(own_contacts_, static_cast<int>(bead), {}, lower_bead);
    };
    const SwimmerContacts contacts{.own = {first_contact(ranges[s].first), first_contact(ranges[s].last)},
                                   .external_forces = external_forces,
                                   .external_stiffness = stiffness[s - first_]};
    const auto add_part = [&]<int Size>(std::integral_constant<int, Size>) {
      parts_.push_back(implicit_swimmer<Size>(scene, step, s, contacts));
    };
    if (ranges[s].last - ranges[s].first == 3) {
      add_part(std::integral_constant<int, size_of_three_beads>{});
    } else {
      add_part(std::integral_constant<int, Eigen::Dynamic>{});
    }
  }
}

/// Evaluates value(range, part) for each swimmer of this rank, where `range` are its beads and `part` is its
/// linear system. Returns the values of the swimmers of all ranks. Collective.
template <class Value>
Beads ImplicitBalance::gather(const Value& value) const {
  Beads beads(step_.positions.size());
  for (std::size_t s = first_; s < last_; ++s) {
    const BeadRange& range = scene_.bead_ranges[s];
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
  const int ranks = scene_.communicator.size();
  const auto& ranges = scene_.bead_ranges;
  if (ranks == 1) return;
  std::vector<int> counts, starts;
  for (int r = 0; r < ranks; ++r) {
    const auto [first, last] = rank_share(std::ssize(ranges), r, ranks);
    const std::size_t begin = first < std::ssize(ranges) ? ranges[first].first : beads.size();
    const std::size_t end = first < last ? ranges[last - 1].last : begin;
    counts.push_back(static_cast<int>(3 * (end - begin)));
    starts.push_back(static_cast<int>(3 * begin));
  }
  MPI_Allgatherv(MPI_IN_PLACE, 0, MPI_DATATYPE_NULL, beads[0].data(), counts.data(), starts.data(),
                 MPI_DOUBLE, scene_.communicator.get());
}

Beads ImplicitBalance::initial_displacements() const {
  return gather([&](const BeadRange&, const auto& part) { return part.end; });
}

Beads ImplicitBalance::initial_forces() const {
  return gather([&](const BeadRange&, const auto& part) { return part.forces; });
}

Beads ImplicitBalance::displacements(const Beads& velocities) const {
  Beads u = step_.history.displacements;
  flat(u) = (flat(step_.history.displacements) + step_.rule.span * flat(velocities)) / step_.rule.weight;
  return u;
}

/// Returns u - u*: the displacements u of the beads at the end of a step with these velocities, minus the
/// expansion point u*.
Beads ImplicitBalance::displacements_from_expansion(const Beads& velocities) const {
  Beads beyond = displacements(velocities);
  flat(beyond) -= flat(step_.expansion_point);
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
  const double compliance = step_.rule.span / step_.rule.weight;
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
  for (const auto* contacts : {&own_contacts_, &external_contacts_})
    for (const Contact& c : *contacts) {
      const double gap = c.gap + gap_change(c, beyond);
      if (gap < c.cutoff)  // reported gap: bead to wall, half of bead to image
        smallest = std::min(smallest, c.first == c.second ? gap / 2 : gap);
    }
  return smallest;
}

}  // namespace beadswim
