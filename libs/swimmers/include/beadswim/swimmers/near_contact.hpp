#pragma once

#include <array>

#include "beadswim/swimmers/lubrication.hpp"
#include "beadswim/core/vec3.hpp"

// What two beads hand each other within a step when they are close: through the film between them
// (lubrication.hpp), and when they touch. Any coherent units. See docs/method/near-contact.md.

namespace beadswim {

struct NearContactLaw {
  double viscosity = 0;       ///< eta
  LubricationRange range;     ///< of the film
  double stiffness_rate = 0;  ///< sqrt(k/m), m the reduced mass: pi over the time of a collision [1/time]
  double damping_ratio = 0;   ///< c/(2 sqrt(k m)) of the dashpot beside the spring
  double friction = 0;        ///< Coulomb's coefficient
  double contact_reach = 0;   ///< gap that beads may close in a step [length]

  /// Gap below which there is anything between two beads.
  double reach() const { return std::max({range.normal, range.tangential, contact_reach}); }
};

/// A bead at the start of the step. Velocities: those that it would have at the end of the step if the other
/// bead were not there.
struct CloseBead {
  double radius = 0, mass = 0, inertia = 0;
  Vec3 velocity = Vec3::Zero(), angular_velocity = Vec3::Zero();
  /// Among how many firm pairs its mass is divided, 1 at least: the sum of PairImpulse::firmness over its
  /// pairs in the step before. Each pair finds its impulse as if it were alone; with parts of the mass,
  /// impulses of several do not overshoot together (Tonge, Benevolenski & Voroshilov 2012).
  double pairs = 1;
};

/// Handed to the second bead, and taken from the first; torques about each bead's centre.
/// first_angular + second_angular + separation x linear = 0.
struct PairImpulse {
  Vec3 linear = Vec3::Zero(), first_angular = Vec3::Zero(), second_angular = Vec3::Zero();
  double firmness = 0;  ///< part of the pair's relative velocity that film and spring take in a step, 0 to 1
};

/// separation: of the centres, from the first to the second bead, at the start of the step. Implicit in the
/// velocities, so that any step is stable: resistance and spring act at the gap and the velocities at the end
/// of the step, dh/dt and w:
///
///   m (dh/dt - dh/dt*) = Phi(h) - Phi(h + step dh/dt) + step max(0, k overlap - c dh/dt)
///   (1 + M C) w = w*,   then  |friction| <= mu |contact|
///
/// with Phi = squeezing().momentum, C = step sliding() and M what angular impulses do to w, so that the film
/// takes what it should on the way however long the step. Where a bead is in n > 1 firm pairs the film takes,
/// per step, at most m/(n - 1) of the velocity: what the others do meanwhile is known to it a step late, and
/// a stiffer one would hold a wrong gap against the spring.
PairImpulse near_contact_impulse(const NearContactLaw& law, const CloseBead& first, const CloseBead& second,
                                 const Vec3& separation, double step);

/// Of the beads of one swimmer among themselves.
struct ChainContact {
  std::array<Vec3, 3> linear, angular;  ///< impulse and angular impulse to each bead
  std::array<double, 3> firmness{};     ///< sums of PairImpulse::firmness over each bead's pairs
};

/// Three beads and their places: all pairs that are close find their impulses together, each knowing what the
/// others do, by Gauss and Seidel's iteration, to roundoff unless the middle bead is much the lightest: in
/// films as good as rigid, 1 % of the velocity was left where it weighs a 27th of the others, 19 % at a
/// hundredth. CloseBead::pairs has no effect.
ChainContact chain_contact(const NearContactLaw& law, const std::array<CloseBead, 3>& beads,
                           const std::array<Vec3, 3>& positions, double step);

}  // namespace beadswim
