#include "implicit_swimmer.hpp"

#include <algorithm>

#include "beadswim/mobility/mobility_matrix.hpp"
#include "beadswim/mobility/step_mobility.hpp"

namespace beadswim {
namespace {

/// Adds the forces and the stiffness of contacts between the beads of one swimmer to `forces` and
/// `stiffness`.
template <int Size>
void add_own_contacts(const SwimmerType& type, double strength, double cutoff_per_radius,
                      const BeadVectors& beads, SwimmerVector<Size>& forces, SwimmerMatrix<Size>& stiffness) {
  for (int i = 0; i < beads.cols(); ++i) {
    for (int j = i + 1; j < beads.cols(); ++j) {
      const Vec3 d = beads.col(i) - beads.col(j);
      const double distance = d.norm(), radii = type.beads[i].radius + type.beads[j].radius;
      const ContactForce law = contact_force(distance - radii, cutoff_per_radius * radii / 2, strength);
      if (!(law.stiffness > 0 && distance > 0)) continue;
      const Vec3 normal = d / distance;
      forces.template segment<3>(3 * i) += law.force * normal;
      forces.template segment<3>(3 * j) -= law.force * normal;
      const Eigen::Matrix3d along = law.stiffness * normal * normal.transpose();
      stiffness.template block<3, 3>(3 * i, 3 * i) += along;
      stiffness.template block<3, 3>(3 * j, 3 * j) += along;
      stiffness.template block<3, 3>(3 * i, 3 * j) -= along;
      stiffness.template block<3, 3>(3 * j, 3 * i) -= along;
    }
  }
}

}  // namespace

template <int Size>
ImplicitSwimmer<Size> implicit_swimmer(const StepRule& rule, const SwimmerSurroundings<Size>& s) {
  using Vector = SwimmerVector<Size>;
  using Matrix = SwimmerMatrix<Size>;
  const Vector places = s.start + s.expansion_point;
  const BeadVectors beads = Eigen::Map<const Eigen::Matrix3Xd>(places.data(), 3, places.size() / 3);
  const double compliance = rule.span / rule.weight;  // du/dv
  ImplicitSwimmer<Size> result;
  const double kappa = s.step_wavenumber;
  // A lambda instead of the function: the compiler inlines it.
  const auto law = [&](double a_i, double a_j, double r, double eta) {
    return kappa == 0 ? rotne_prager_tensor(a_i, a_j, r, eta) : step_tensor(a_i, a_j, r, eta, kappa);
  };
  result.mobility = mobility_matrix<Matrix>(law, s.type.beads, beads, s.viscosity);
  for (Eigen::Index k = 0; k < places.size() && kappa > 0; ++k)
    result.mobility(k, k) *= step_self_ratio(kappa * s.type.beads[k / 3].radius);
  const BeadVectors driving = driving_forces(s.type, rule.time, beads, s.initial_orientation);
  Vector forces = own_forces<Size>(s.type, rule.time, beads) + as_vector<Size>(driving);
  Matrix stiffness = own_stiffness<Size>(s.type, rule.time, beads);
  add_own_contacts(s.type, s.contact_strength, s.own_cutoff_per_radius, beads, forces, stiffness);
  const Vector still = s.history / rule.weight - s.expansion_point;  // u - u* at v = 0
  result.drive = forces - stiffness * still;
  result.resistance = compliance * stiffness;
  if (std::ranges::any_of(s.type.bonds, [](const Bond& bond) { return bond.damping > 0; }))
    result.resistance += own_damping<Size>(s.type, beads);
  if (kappa > 0) {
    result.resistance.diagonal() += s.inertia;
    result.drive += s.inertia_forces;
  }
  Matrix resistance = result.resistance;
  Vector drive = result.drive + s.external_forces;
  if (s.external_stiffness.size() > 0) {
    resistance += compliance * s.external_stiffness;
    drive -= s.external_stiffness * still;
  }
  result.balance.compute(Matrix::Identity(places.size(), places.size()) + resistance * result.mobility);
  result.forces = result.balance.solve(drive - resistance * s.distant);
  result.end = (s.history + rule.span * (result.mobility * result.forces + s.distant)) / rule.weight;
  return result;
}

template ImplicitSwimmer<size_of_three_beads> implicit_swimmer(
    const StepRule&, const SwimmerSurroundings<size_of_three_beads>&);
template ImplicitSwimmer<Eigen::Dynamic> implicit_swimmer(const StepRule&,
                                                          const SwimmerSurroundings<Eigen::Dynamic>&);

}  // namespace beadswim
