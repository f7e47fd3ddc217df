#pragma once

#include <array>

#include "beadswim/swimmers/lubrication.hpp"
#include "beadswim/core/vec3.hpp"

// Impulses that two close beads exchange within a time step: through the film between them (lubrication.hpp)
// and by contact. Any coherent units. See docs/method/near-contact.md.

namespace beadswim {

/// Parameters of lubrication, contact and friction.
struct NearContactLaw {
  double viscosity = 0;       ///< eta, dynamic viscosity [mass/(length time)]
  LubricationRange range;     ///< gaps at which the resistance of the film is added
  double stiffness_rate = 0;  ///< sqrt(k/m), m: reduced mass; a collision takes pi/stiffness_rate [1/time]
  double damping_ratio = 0;   ///< c/(2 sqrt(k m)), c: dashpot parallel to the spring k
  double friction = 0;        ///< Coulomb's friction coefficient
  double contact_cutoff = 0;  ///< largest gap that two beads can close in one step [length]

  /// Returns the gap below which two beads interact [length].
  double cutoff() const { return std::max({range.normal, range.tangential, contact_cutoff}); }
};

/// A bead at the start of the step. The velocities are those that the bead would have at the end of the step
/// without the other bead. inertia: moment of inertia.
struct CloseBead {
  double radius = 0, mass = 0, inertia = 0;
  Vec3 velocity = Vec3::Zero(), angular_velocity = Vec3::Zero();
  /// Effective number of pairs that share the mass of the bead, at least 1: the sum of
  /// PairImpulse::removed_fraction over its pairs in the previous step. Each pair evaluates its impulse
  /// without knowing the other pairs. With a share of the mass in each pair, the sum of the impulses does not
  /// overshoot (Tonge, Benevolenski & Voroshilov 2012).
  double pairs = 1;
};

/// Impulse `linear` on the second bead and -linear on the first bead. Angular impulses on the first and
/// second bead, each about the bead's centre. They satisfy
/// first_angular + second_angular + separation x linear = 0.
struct PairImpulse {
  Vec3 linear = Vec3::Zero(), first_angular = Vec3::Zero(), second_angular = Vec3::Zero();
  double removed_fraction = 0;  ///< of the relative normal velocity, by film and spring in one step, 0 to 1
};

/// Returns the impulses that two beads exchange within a step of length `step`. separation: vector from the
/// centre of the first bead to the centre of the second bead at the start of the step.
///
/// The scheme is implicit in the velocities and stable for any step. Resistance and spring act at the gap and
/// at the velocities dh/dt and w of the end of the step. A star marks velocities without the exchanged
/// impulses:
///
///   m (dh/dt - dh/dt*) = Phi(h) - Phi(h + step dh/dt) + step max(0, k overlap - c dh/dt)
///   (1 + M C) w = w*,   then  |friction| <= mu |contact|
///
/// m: reduced mass; Phi = squeezing().momentum; C = step sliding(); M: change of w per angular impulse. With
/// Phi the film removes the correct momentum between the two gaps for any step. If a bead has n > 1 pairs
/// (CloseBead::pairs), the resistance of the film is limited to m/((n - 1) step). The pair knows the impulses
/// of the other pairs one step late, and a larger resistance would keep a wrong gap against the force of the
/// spring.
PairImpulse near_contact_impulse(const NearContactLaw& law, const CloseBead& first, const CloseBead& second,
                                 const Vec3& separation, double step);

/// Impulses among the three beads of one swimmer.
struct ChainContact {
  std::array<Vec3, 3> linear, angular;       ///< impulse and angular impulse on each bead
  std::array<double, 3> removed_fraction{};  ///< sum over the pairs of each bead
};

/// Returns the impulses among the three beads of a swimmer at `positions`. A Gauss-Seidel iteration makes the
/// impulse of each close pair consistent with the impulses of the other pairs. It converges to roundoff
/// unless the middle bead is much lighter than the others. With nearly rigid films, the residual was 1 % of
/// the velocity if the middle bead had 1/27 of the mass of the others, and 19 % at 1/100. CloseBead::pairs
/// has no effect.
ChainContact chain_contact(const NearContactLaw& law, const std::array<CloseBead, 3>& beads,
                           const std::array<Vec3, 3>& positions, double step);

}  // namespace beadswim
