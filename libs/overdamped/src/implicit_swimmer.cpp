#include "implicit_swimmer.hpp"

#include <algorithm>

#include "beadswim/mobility/mobility_matrix.hpp"
#include "beadswim/mobility/step_mobility.hpp"

namespace beadswim {
namespace {

/// Adds the forces and the stiffness of contacts between beads of one swimmer. first: number of its first
/// bead.
template <int Size>
void add_contacts(std::span<const Contact> contacts, std::size_t first, SwimmerVector<Size>& forces,
                  SwimmerMatrix<Size>& stiffness) {
  for (const Contact& c : contacts) {
    const auto i = 3 * (c.first - first), j = 3 * (c.second - first);
    forces.template segment<3>(i) += c.law.force * c.normal;
    forces.template segment<3>(j) -= c.law.force * c.normal;
    const Eigen::Matrix3d along = c.law.stiffness * c.normal * c.normal.transpose();
    stiffness.template block<3, 3>(i, i) += along;
    stiffness.template block<3, 3>(j, j) += along;
    stiffness.template block<3, 3>(i, j) -= along;
    stiffness.template block<3, 3>(j, i) -= along;
  }
}

}  // namespace

template <int Size>
ImplicitSwimmer<Size> implicit_swimmer(const StepScene& step_scene, const StepStart& step, std::size_t number,
                                       const SwimmerContacts& contacts) {
  using Vector = SwimmerVector<Size>;
  using Matrix = SwimmerMatrix<Size>;
  const OverdampedScene& scene = step_scene.scene;
  const PlacedSwimmer& swimmer = scene.swimmers[number];
  const SwimmerType& type = scene.type_of(swimmer);
  const BeadRange& range = step_scene.bead_ranges[number];
  const auto own = [&range](const Beads& beads) { return swimmer_vector<Size>(beads, range); };
  const Vector history = own(step.history.displacements), distant = own(step.distant);
  const Vector places = own(step.positions) + own(step.expansion_point);
  const BeadVectors beads = Eigen::Map<const Eigen::Matrix3Xd>(places.data(), 3, places.size() / 3);
  const auto& [weight, span, time] = step.rule;
  const double compliance = span / weight;  // du/dv
  ImplicitSwimmer<Size> result;
  const double kappa = scene.memory && span > 0
                           ? step_wavenumber(scene.viscosity / scene.memory->density * span)
                           : 0;  // 0: steady flow
  // A lambda instead of the function: the compiler inlines it.
  const auto law = [&](double a_i, double a_j, double r, double eta) {
    return kappa == 0 ? rotne_prager_tensor(a_i, a_j, r, eta) : step_tensor(a_i, a_j, r, eta, kappa);
  };
  result.mobility = mobility_matrix<Matrix>(law, type.beads, beads, scene.viscosity);
  for (Eigen::Index k = 0; k < places.size() && kappa > 0; ++k)
    result.mobility(k, k) *= step_self_ratio(kappa * type.beads[k / 3].radius);
  const BeadVectors driving = driving_forces(type, time, beads, swimmer.orientation);
  Vector forces = own_forces<Size>(type, time, beads) + as_vector<Size>(driving);
  Matrix stiffness = own_stiffness<Size>(type, time, beads);
  add_contacts(contacts.own, range.first, forces, stiffness);
  const Vector still = history / weight - own(step.expansion_point);  // u - u* at v = 0
  result.drive = forces - stiffness * still;
  result.resistance = compliance * stiffness;
  if (std::ranges::any_of(type.bonds, [](const Bond& bond) { return bond.damping > 0; }))
    result.resistance += own_damping<Size>(type, beads);
  for (std::size_t b = range.first; b < range.last && kappa > 0; ++b) {
    const double mass = step_scene.excess_masses[b];
    const auto first = 3 * static_cast<Eigen::Index>(b - range.first);
    result.resistance.diagonal().template segment<3>(first).array() += mass * weight / span;
    result.drive.template segment<3>(first) += mass / span * step.history.velocities[b];
  }
  Matrix resistance = result.resistance;
  Vector drive = result.drive + own(contacts.external_forces);
  if (contacts.external_stiffness.size() > 0) {
    resistance += compliance * contacts.external_stiffness;
    drive -= contacts.external_stiffness * still;
  }
  result.balance.compute(Matrix::Identity(places.size(), places.size()) + resistance * result.mobility);
  result.forces = result.balance.solve(drive - resistance * distant);
  result.end = (history + span * (result.mobility * result.forces + distant)) / weight;
  return result;
}

#define BEADSWIM_INSTANTIATE(Size)                                                                 \
  template ImplicitSwimmer<Size> implicit_swimmer(const StepScene&, const StepStart&, std::size_t, \
                                                  const SwimmerContacts&);
BEADSWIM_INSTANTIATE(size_of_three_beads)
BEADSWIM_INSTANTIATE(Eigen::Dynamic)
#undef BEADSWIM_INSTANTIATE

}  // namespace beadswim
