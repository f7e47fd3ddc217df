#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "beadswim/core/vec3.hpp"
#include "beadswim/swimmers/lubrication.hpp"

// Impulses that two close beads exchange within a time step: through the film between them (lubrication.hpp)
// and by contact. Quantities are in any coherent units. See docs/method/near-contact.md.

namespace beadswim {

/// Parameters of lubrication, contact and friction.
struct NearContactLaw {
  double viscosity = 0;    ///< eta, dynamic viscosity [mass/(length time)]
  LubricationRange range;  ///< gaps at which the resistance of the film is added
  /// Rate sqrt(k/m) [1/time] of the contact spring. k: its stiffness; m: reduced mass of the two beads. A
  /// collision lasts pi/stiffness_rate.
  double stiffness_rate = 0;
  /// Damping ratio c/(2 sqrt(k m)) of the contact. c: damping of the dashpot parallel to the spring.
  double damping_ratio = 0;
  double friction = 0;        ///< Coulomb's friction coefficient
  double contact_cutoff = 0;  ///< largest gap that two beads can close in one step [length]

  /// Returns the gap below which two beads interact [length].
  double cutoff() const { return std::max({range.normal, range.tangential, contact_cutoff}); }
};

/// One bead of a close pair at the start of the time step. The velocities are those that the bead would have
/// at the end of the step if the other bead did not act on it. inertia: moment of inertia.
struct CloseBead {
  double radius = 0, mass = 0, inertia = 0;
  Vec3 velocity = Vec3::Zero(), angular_velocity = Vec3::Zero();
  /// Effective number of close pairs that share the mass of the bead: the sum of
  /// PairImpulse::removed_fraction over its pairs in the previous step, but at least 1. Each pair evaluates
  /// its impulse without knowledge of the impulses of the other pairs, and therefore uses only a share of the
  /// mass. The sum of the impulses then does not overshoot (Tonge, Benevolenski & Voroshilov 2012).
  double pairs = 1;
};

/// Impulses on the two beads of a close pair: `linear` on the second bead and -linear on the first bead, and
/// an angular impulse on each bead about its centre. The impulses conserve angular momentum: first_angular +
/// second_angular + separation x linear = 0, where separation is the vector from the first to the second
/// centre.
struct PairImpulse {
  Vec3 linear = Vec3::Zero(), first_angular = Vec3::Zero(), second_angular = Vec3::Zero();
  double removed_fraction = 0;  ///< part of the relative normal velocity that film and spring remove per step
};

/// Returns the impulses that two beads exchange within a step of length `step`. separation: vector from the
/// centre of the first bead to the centre of the second bead at the start of the step.
///
/// The scheme is implicit in the velocities and stable for any step. The resistance of the film and the
/// contact spring are evaluated with the gap and with the velocities dh/dt and w at the end of the step. A
/// star marks velocities without the exchanged impulses:
///
///   m (dh/dt - dh/dt*) = Phi(h) - Phi(h + step dh/dt) + step max(0, k overlap - c dh/dt)
///   (1 + M C) w = w*,   then  |friction| <= mu |contact|
///
/// h: gap at the start of the step; w: angular velocities of the beads relative to their line of centres; m:
/// reduced mass; k, c: stiffness and damping of the contact; mu: friction coefficient; friction, contact:
/// impulses; Phi = squeezing().momentum; C = step sliding(); M: change of w per angular impulse. With Phi,
/// the film removes the correct momentum between the gaps at the start and at the end of the step, for a step
/// of any length.
///
/// If a bead has n > 1 close pairs (CloseBead::pairs), the resistance of the film is limited to m/((n - 1)
/// step), because the impulses of the other pairs are known only from the previous step. A larger resistance
/// would keep the gap at a wrong value against the force of the contact spring.
PairImpulse near_contact_impulse(const NearContactLaw& law, const CloseBead& first, const CloseBead& second,
                                 const Vec3& separation, double step);

/// Impulses among the beads of one swimmer, one entry per bead.
struct SwimmerContact {
  std::vector<Vec3> linear, angular;     ///< impulse and angular impulse on each bead
  std::vector<double> removed_fraction;  ///< PairImpulse::removed_fraction, summed over each bead's pairs
};

/// Returns the impulses among the beads of a swimmer at `positions`. A Gauss-Seidel iteration makes the
/// impulse of each close pair consistent with the impulses of the other pairs. The iteration converges to
/// roundoff unless a bead between two others is much lighter. In a test with nearly rigid films between three
/// beads, one end bead moved towards the others, which were at rest. Its velocity then differed from the
/// common velocity by 1 % of its initial velocity if the middle bead had 1/27 of the mass of an end bead, and
/// by 19 % if it had 1/100. CloseBead::pairs is ignored.
SwimmerContact swimmer_contact(const NearContactLaw& law, std::span<const CloseBead> beads,
                               std::span<const Vec3> positions, double step);

}  // namespace beadswim
