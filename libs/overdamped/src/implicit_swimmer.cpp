#include "implicit_swimmer.hpp"

namespace beadswim {
namespace {

BeadVectors beads_of(const Vector9& x) {
  return {x.segment<3>(0), x.segment<3>(3), x.segment<3>(6)};
}

/// Adds the forces and the stiffness of contacts between the three beads of one swimmer to `forces` and
/// `stiffness`.
void add_own_contacts(const SwimmerType& type, const ContactScale& scale, const BeadVectors& beads,
                      Vector9& forces, Matrix9& stiffness) {
  for (const auto& [i, j] : {std::pair{0, 1}, {0, 2}, {1, 2}}) {
    const Vec3 d = beads[i] - beads[j];
    const double distance = d.norm(), radii = type.beads[i].radius + type.beads[j].radius;
    const ContactForce law =
        contact_force(distance - radii, scale.cutoff_per_radius * radii / 2, scale.strength);
    if (!(law.stiffness > 0 && distance > 0)) continue;
    const Vec3 normal = d / distance;
    forces.segment<3>(3 * i) += law.force * normal;
    forces.segment<3>(3 * j) -= law.force * normal;
    const Eigen::Matrix3d along = law.stiffness * normal * normal.transpose();
    stiffness.block<3, 3>(3 * i, 3 * i) += along;
    stiffness.block<3, 3>(3 * j, 3 * j) += along;
    stiffness.block<3, 3>(3 * i, 3 * j) -= along;
    stiffness.block<3, 3>(3 * j, 3 * i) -= along;
  }
}

}  // namespace

ImplicitSwimmer implicit_swimmer(const StepRule& rule, const SwimmerSurroundings& s) {
  const BeadVectors beads = beads_of(s.start + s.expansion_point);
  const double compliance = rule.span / rule.weight;  // du/dv
  ImplicitSwimmer result;
  result.mobility = own_mobility(s.type, beads, s.viscosity);
  Vector9 forces =
      own_forces(s.type, beads) + as_vector(driving_forces(s.type.driving, rule.time, beads, s.initial_axis));
  Matrix9 stiffness = own_stiffness(s.type, beads);
  add_own_contacts(s.type, s.scale, beads, forces, stiffness);
  const Vector9 still = s.history / rule.weight - s.expansion_point;  // u - u* at v = 0
  result.drive = forces - stiffness * still;
  result.resistance = compliance * stiffness;
  if (s.type.springs[0].damping > 0 || s.type.springs[1].damping > 0)
    result.resistance += own_damping(s.type, beads);
  const Matrix9 resistance = result.resistance + compliance * s.external_stiffness;
  const Vector9 drive = result.drive + s.external_forces - s.external_stiffness * still;
  result.balance.compute(Matrix9::Identity() + resistance * result.mobility);
  result.forces = result.balance.solve(drive - resistance * s.distant);
  result.end = (s.history + rule.span * (result.mobility * result.forces + s.distant)) / rule.weight;
  return result;
}

}  // namespace beadswim
