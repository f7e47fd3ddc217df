#pragma once

#include <array>
#include <span>

#include "beadswim/core/fields.hpp"
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

/// Symmetric traceless part of r p, summed over impulses p at r from the centre of a bead. The bits do not
/// depend on the order of the terms.
struct StressSum {
  std::array<OrderFreeSum, 5> sums;  ///< of T = (r p + p r)/2: T_xx - T_zz, T_yy - T_zz, T_xy, T_xz, T_yz

  void add(const Vec3& r, const Vec3& p) {
    const double zz = r[2] * p[2];
    sums[0].add(r[0] * p[0] - zz);
    sums[1].add(r[1] * p[1] - zz);
    sums[2].add((r[0] * p[1] + r[1] * p[0]) / 2);
    sums[3].add((r[0] * p[2] + r[2] * p[0]) / 2);
    sums[4].add((r[1] * p[2] + r[2] * p[1]) / 2);
  }
  void add(const StressSum& other) {
    for (std::size_t n = 0; n < sums.size(); ++n) sums[n].add(other.sums[n]);
  }
  Eigen::Matrix3d value() const {
    const double xy = sums[2].value(), xz = sums[3].value(), yz = sums[4].value();
    const double zz = -(sums[0].value() + sums[1].value()) / 3;
    return Eigen::Matrix3d{{sums[0].value() + zz, xy, xz}, {xy, sums[1].value() + zz, yz}, {xz, yz, zz}};
  }
};

/// Impulses that the fluid and close beads transfer to a bead in one step, in lattice units.
struct Impulse {
  LoadSum fluid;             ///< from the fluid
  StressSum stress;          ///< by the impulse from the fluid
  OrderFreeSum mass;         ///< fluid mass that the bead takes up, beyond density 1
  OrderFreeSum link_weight;  ///< sum of the weights w_i of the links of the bead
  LoadSum inner;             ///< momentum of the fluid within the bead, for the scheme psm
  LoadSum close;             ///< from close beads
  /// Part of the relative normal velocity that lubrication film and contact spring of a close pair remove in
  /// one step, summed over the close pairs of the bead.
  OrderFreeSum removed_fraction;

  static void visit_fields(auto&& visit, auto&... impulses) {
    visit("fluid", impulses.fluid...);
    visit("stress", impulses.stress...);
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

  BEADSWIM_FIELDS(linear, angular)
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
  BEADSWIM_FIELDS(name, owner, radius, mass_source, body, removed_fraction, predicted, motion)

  /// Returns the velocity of the rigid bead at the point `from_centre` relative to its centre [cell/step].
  Vec3 velocity_at(const Vec3& from_centre) const {
    return motion.velocity + motion.angular_velocity.cross(from_centre);
  }
};

}  // namespace beadswim
