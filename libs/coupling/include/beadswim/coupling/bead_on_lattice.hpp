#pragma once

#include <array>

#include "beadswim/core/order_free_sum.hpp"
#include "beadswim/core/vec3.hpp"
#include "beadswim/swimmers/swimmer_dynamics.hpp"

namespace beadswim {

/// Identifies a bead in the scene.
struct BeadName {
  int swimmer = 0;  ///< id of the swimmer
  int bead = 0;     ///< index of the bead in its swimmer

  auto operator<=>(const BeadName&) const = default;
};

/// Impulses that the fluid and close beads transfer to a bead in one step, in lattice units. Each member is a
/// sum whose bits do not depend on the order of its terms.
struct Impulse {
  /// From the fluid: momentum, and angular momentum about the centre of the bead.
  std::array<OrderFreeSum, 3> linear, angular;
  OrderFreeSum mass;         ///< fluid mass that the bead takes up, beyond density 1
  OrderFreeSum link_weight;  ///< sum of the weights w_i of the links of the bead
  /// Momentum and angular momentum of the fluid within the bead, for the scheme psm.
  std::array<OrderFreeSum, 3> inner_linear, inner_angular;
  std::array<OrderFreeSum, 3> close_linear, close_angular;  ///< momentum, angular momentum from close beads
  /// Part of the relative normal velocity that lubrication film and contact spring of a close pair remove in
  /// one step, summed over the close pairs of the bead.
  OrderFreeSum removed_fraction;

  static void visit_fields(auto&& visit, auto&... impulses) {
    visit("linear", impulses.linear...);
    visit("angular", impulses.angular...);
    visit("mass", impulses.mass...);
    visit("link_weight", impulses.link_weight...);
    visit("inner_linear", impulses.inner_linear...);
    visit("inner_angular", impulses.inner_angular...);
    visit("close_linear", impulses.close_linear...);
    visit("close_angular", impulses.close_angular...);
    visit("removed_fraction", impulses.removed_fraction...);
  }

  /// Adds the momentum p that acts at `from_centre`, relative to the centre of the bead.
  void add(const Vec3& p, const Vec3& from_centre) {
    const Vec3 l = from_centre.cross(p);
    for (int a = 0; a < 3; ++a) {
      linear[a].add(p[a]);
      angular[a].add(l[a]);
    }
  }
  void add(const Impulse& other) {
    visit_fields([](const char*, auto& sum, const auto& term) { add_to(sum, term); }, *this, other);
  }
  Load value() const { return {value_of(linear), value_of(angular)}; }
  Load inner_value() const { return {value_of(inner_linear), value_of(inner_angular)}; }
  Load close_value() const { return {value_of(close_linear), value_of(close_angular)}; }

 private:
  static void add_to(OrderFreeSum& sum, const OrderFreeSum& term) { sum.add(term); }
  static void add_to(std::array<OrderFreeSum, 3>& sums, const std::array<OrderFreeSum, 3>& terms) {
    for (int a = 0; a < 3; ++a) sums[a].add(terms[a]);
  }
  static Vec3 value_of(const std::array<OrderFreeSum, 3>& sums) {
    return {sums[0].value(), sums[1].value(), sums[2].value()};
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
