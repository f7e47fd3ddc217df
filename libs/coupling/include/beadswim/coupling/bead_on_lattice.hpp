#pragma once

#include <array>

#include "beadswim/swimmers/swimmer_dynamics.hpp"
#include "beadswim/core/order_free_sum.hpp"
#include "beadswim/core/vec3.hpp"

namespace beadswim {

/// Name of a bead in the whole scene.
struct BeadName {
  int swimmer = 0;  ///< id
  int bead = 0;     ///< 0, 1, 2

  auto operator<=>(const BeadName&) const = default;
};

/// What the fluid and close beads hand to a bead, in sums without order.
struct Impulse {
  std::array<OrderFreeSum, 3> linear, angular;  ///< momentum, and angular momentum about the centre
  OrderFreeSum mass;                            ///< of fluid, over that of as many cells at density 1
  OrderFreeSum link_weight;                     ///< sum of w_i over the bead's links
  std::array<OrderFreeSum, 3> inner_linear,
      inner_angular;  ///< what fluid within the bead has, where there is
  std::array<OrderFreeSum, 3> close_linear, close_angular;  ///< from beads that are close
  OrderFreeSum firmness;                                    ///< PairImpulse::firmness of these pairs

  /// Adds the momentum p handed over at `from_centre`.
  void add(const Vec3& p, const Vec3& from_centre) {
    const Vec3 l = from_centre.cross(p);
    for (int a = 0; a < 3; ++a) {
      linear[a].add(p[a]);
      angular[a].add(l[a]);
    }
  }
  void add(const Impulse& other) {
    for (int a = 0; a < 3; ++a) {
      linear[a].add(other.linear[a]);
      angular[a].add(other.angular[a]);
      inner_linear[a].add(other.inner_linear[a]);
      inner_angular[a].add(other.inner_angular[a]);
      close_linear[a].add(other.close_linear[a]);
      close_angular[a].add(other.close_angular[a]);
    }
    firmness.add(other.firmness);
    mass.add(other.mass);
    link_weight.add(other.link_weight);
  }
  Load value() const { return {value_of(linear), value_of(angular)}; }
  Load inner_value() const { return {value_of(inner_linear), value_of(inner_angular)}; }
  Load close_value() const { return {value_of(close_linear), value_of(close_angular)}; }

 private:
  static Vec3 value_of(const std::array<OrderFreeSum, 3>& sums) {
    return {sums[0].value(), sums[1].value(), sums[2].value()};
  }
};

/// Of a rigid bead.
struct BeadVelocity {
  Vec3 linear = Vec3::Zero(), angular = Vec3::Zero();
};

/// A bead as the ranks see whose cells it touches.
struct BeadOnLattice {
  BeadName name;
  int owner = 0;      ///< rank that advances it and gathers its impulses
  double radius = 0;  ///< with which the fluid meets it
  BeadMotion motion;
  Bead body{};               ///< with which other beads meet it
  BeadVelocity predicted{};  ///< at the end of the coming step, if no other bead were close
  double firmness = 0;       ///< of its close pairs in the last step
  double mass_source = 0;    ///< fluid mass that each link returns in this step, over its weight w_i
  Impulse impulse;           ///< from this rank's cells, since the last time the owner collected

  /// Velocity of the rigid bead at a point relative to its centre.
  Vec3 velocity_at(const Vec3& from_centre) const {
    return motion.velocity + motion.angular_velocity.cross(from_centre);
  }
};

}  // namespace beadswim
