#pragma once

#include <array>

#include "beadswim/core/order_free_sum.hpp"
#include "beadswim/core/vec3.hpp"
#include "beadswim/swimmers/swimmer_dynamics.hpp"

namespace beadswim {

/// Identifies a bead in the scene.
struct BeadName {
  int swimmer = 0;  ///< id
  int bead = 0;     ///< 0, 1, 2

  auto operator<=>(const BeadName&) const = default;
};

/// Impulses that the fluid and close beads transfer to a bead, as order-free sums.
struct Impulse {
  std::array<OrderFreeSum, 3> linear, angular;  ///< momentum, and angular momentum about the centre
  OrderFreeSum mass;         ///< fluid mass, minus the mass of the same number of cells at density 1
  OrderFreeSum link_weight;  ///< sum of w_i over the links of the bead
  std::array<OrderFreeSum, 3> inner_linear, inner_angular;  ///< of the fluid within the bead (psm)
  std::array<OrderFreeSum, 3> close_linear, close_angular;  ///< impulses from close beads
  OrderFreeSum removed_fraction;  ///< sum of PairImpulse::removed_fraction over the close pairs

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

  /// Adds the momentum p, transferred at the point `from_centre` relative to the centre of the bead.
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
  int owner = 0;      ///< rank that advances it and gathers its impulses
  double radius = 0;  ///< radius for the fluid [cell]
  BeadMotion motion;
  Bead body{};                  ///< radius and density for the interaction with other beads
  BeadVelocity predicted{};     ///< velocities at the end of the next step if no other bead were close
  double removed_fraction = 0;  ///< sum over its close pairs in the last step
  double mass_source = 0;  ///< returned mass: fluid mass that each link returns in this step, divided by w_i
  Impulse impulse;         ///< from the cells of this rank since the last collection by the owner

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

  /// Returns the velocity of the rigid bead at a point relative to its centre.
  Vec3 velocity_at(const Vec3& from_centre) const {
    return motion.velocity + motion.angular_velocity.cross(from_centre);
  }
};

}  // namespace beadswim
