#pragma once

#include <array>
#include <span>

#include "beadswim/core/order_free_sum.hpp"
#include "beadswim/core/vec3.hpp"
#include "beadswim/scene/fault.hpp"
#include "beadswim/swimmers/swimmer_dynamics.hpp"

namespace beadswim {

/// Momentum, and angular momentum about the centre of a bead: sums whose bits do not depend on the order of
/// their terms.
struct LoadSum {
  std::array<OrderFreeSum, 6> sums;  ///< components of momentum and of angular momentum

  void add(const Vec3& momentum, const Vec3& angular_momentum) {
    for (int a = 0; a < 3; ++a) {
      sums[a].add(momentum[a]);
      sums[3 + a].add(angular_momentum[a]);
    }
  }
  void add(std::span<const OrderFreeSum, 6> terms) {
    for (int n = 0; n < 6; ++n) sums[n].add(terms[n]);
  }
  void add(const LoadSum& other) { add(std::span(other.sums)); }
  Load value() const {
    return {{sums[0].value(), sums[1].value(), sums[2].value()},
            {sums[3].value(), sums[4].value(), sums[5].value()}};
  }
};

/// Impulses that the fluid and close beads transfer to a bead in one step, in lattice units.
struct Impulse {
  LoadSum fluid;             ///< from the fluid
  OrderFreeSum mass;         ///< fluid mass that the bead takes up, beyond density 1
  OrderFreeSum link_weight;  ///< sum of the weights w_i of the links of the bead
  LoadSum inner;             ///< momentum of the fluid within the bead, for the scheme psm
  LoadSum close;             ///< from close beads
  /// Part of the relative normal velocity that lubrication film and contact spring of a close pair remove in
  /// one step, summed over the close pairs of the bead.
  OrderFreeSum removed_fraction;

  static void visit_fields(auto&& visit, auto&... impulses) {
    visit("fluid", impulses.fluid...);
    visit("mass", impulses.mass...);
    visit("link_weight", impulses.link_weight...);
    visit("inner", impulses.inner...);
    visit("close", impulses.close...);
    visit("removed_fraction", impulses.removed_fraction...);
  }

  void add(const Impulse& other) {
    visit_fields([](const char*, auto& sum, const auto& term) { sum.add(term); }, *this, other);
  }
};

/// Velocity and angular velocity of a rigid bead.
struct BeadVelocity {
  Vec3 linear = Vec3::Zero(), angular = Vec3::Zero();

  static void visit_fields(auto&& visit, auto& velocity) {
    visit("linear", velocity.linear);
    visit("angular", velocity.angular);
  }
};

/// A bead as stored by the ranks whose cells it touches, in lattice units.
struct BeadOnLattice {
  BeadName name;
  int owner = 0;      ///< rank that advances the bead and sums its impulses
  double radius = 0;  ///< radius with which the bead acts on the fluid [cell]
  BeadMotion motion;
  Bead body{};                  ///< radius and density for the interaction with other beads
  BeadVelocity predicted{};     ///< velocities at the end of the next step if no other bead were close
  double removed_fraction = 0;  ///< Impulse::removed_fraction of the last step
  /// Returned mass: fluid mass that each link returns in this step, divided by the weight of the link.
  double mass_source = 0;
  Impulse impulse;  ///< impulse from the cells of this rank that has not been sent to the owner yet

  /// Visits the fields that the owner sends to other ranks: all fields except the impulse.
  static void visit_fields(auto&& visit, auto& bead) {
    visit("name", bead.name);
    visit("owner", bead.owner);
    visit("radius", bead.radius);
    visit("mass_source", bead.mass_source);
    visit("body", bead.body);
    visit("removed_fraction", bead.removed_fraction);
    visit("predicted", bead.predicted);
    visit("motion", bead.motion);
  }

  /// Returns the velocity of the rigid bead at the point `from_centre` relative to its centre [cell/step].
  Vec3 velocity_at(const Vec3& from_centre) const {
    return motion.velocity + motion.angular_velocity.cross(from_centre);
  }
};

}  // namespace beadswim
