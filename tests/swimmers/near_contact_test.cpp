#include "beadswim/swimmers/near_contact.hpp"

#include <gtest/gtest.h>

#include "../collinear/bispherical.hpp"
#include "../mobility/transverse_spheres.hpp"
#include "beadswim/swimmers/swimmer_dynamics.hpp"

namespace beadswim {
namespace {

constexpr double pi = std::numbers::pi, eta = 0.3;
constexpr LubricationRange wide{.normal = 0.1, .tangential = 0.1, .smallest = 1e-6};

/// Returns the exact force between approaching spheres of radii a and b with gap h, divided by dh/dt.
double exact_squeezing(double a, double b, double h) {
  const Eigen::Matrix2d r = bispherical_resistance(a, b, a + b + h, eta);
  // The singular part is common to all motions with the same approach.
  return 0.5 * (r * Eigen::Vector2d(-0.5, 0.5)).dot(Eigen::Vector2d(-1, 1));
}

// Between two gaps the law's resistance changes as that of exact Stokes flow does, but for terms of order
// h ln h: 3 % of the change from 0.1 to 0.05, less below. Catches a wrong coefficient of 1/h or of ln(1/h),
// for spheres of unequal radii too.
TEST(Lubrication, OfSqueezingFollowsExactSpheres) {
  for (const double b : {1.0, 2.0, 5.0}) {
    for (const double h : {0.05, 0.02, 0.01, 0.005}) {
      const double exact = exact_squeezing(1, b, h) - exact_squeezing(1, b, wide.normal);
      EXPECT_NEAR(squeezing(1, b, eta, wide, h).resistance / exact, 1, 0.3 * h)
          << "radius " << b << ", gap " << h;
    }
  }
  constexpr double h = 0.03, dh = 1e-4;  // and its integral is its integral
  const double change =
      squeezing(1, 2, eta, wide, h + dh).momentum - squeezing(1, 2, eta, wide, h - dh).momentum;
  EXPECT_NEAR(change / (2 * dh * squeezing(1, 2, eta, wide, h).resistance), 1, 1e-4);
  const double brenner = 6 * pi * eta * (approaching_spheres(2.01) - approaching_spheres(2.1));
  EXPECT_NEAR(2 * squeezing(1, 1, eta, wide, 0.01).resistance / brenner, 1, 0.003);
}

// Likewise for sliding; what is left is of order h, 2 h at most. Catches wrong coefficients of the torques,
// or a wrong force that goes with them, for spheres of unequal radii too.
TEST(Lubrication, OfSlidingFollowsExactSpheres) {
  LubricationRange range = wide;
  for (std::size_t n = 0; transverse_resistances[n + 1].gap <= 0.1; ++n) {
    const TransverseResistance &near = transverse_resistances[n], &far = transverse_resistances[n + 1];
    range.tangential = far.gap;
    const Sliding film = sliding(1, 1, eta, range, near.gap);
    const double slide = 8 * pi * eta * (near.sliding_torque - far.sliding_torque);
    const double roll = 8 * pi * eta * (near.rolling_torque - far.rolling_torque);
    const double force = 6 * pi * eta * (far.sliding_force - near.sliding_force);
    EXPECT_NEAR((film.aa + film.ab) / slide, 1, 2 * far.gap) << near.gap;
    EXPECT_NEAR((film.aa - film.ab) / roll, 1, 2 * far.gap) << near.gap;
    EXPECT_NEAR(2 * (film.aa + film.ab) / (2 + near.gap) / force, 1, 2 * far.gap) << near.gap;
  }
  for (std::size_t n = 0; n + 1 < unequal_sliding.size(); ++n) {
    const UnequalSliding &near = unequal_sliding[n], &far = unequal_sliding[n + 1];
    range.tangential = 1.5 * far.gap;
    const Sliding film = sliding(1, 2, eta, range, 1.5 * near.gap);
    const double torque_1 = film.aa + film.ab, torque_2 = film.ab + film.bb;
    const double force = (torque_1 + torque_2) / (3 + 1.5 * near.gap);
    EXPECT_NEAR(torque_1 / (8 * pi * eta * (near.torque_1 - far.torque_1)), 1, 2 * far.gap) << near.gap;
    EXPECT_NEAR(torque_2 / (8 * pi * eta * 8 * (near.torque_2 - far.torque_2)), 1, 2 * far.gap) << near.gap;
    EXPECT_NEAR(force / (6 * pi * eta * (far.force_1 - near.force_1)), 1, 2 * far.gap) << near.gap;
  }
}

/// Two beads of radii 2 and 3 that move with a gap of h.
struct Scene {
  CloseBead first{.radius = 2, .mass = 30, .inertia = 50}, second{.radius = 3, .mass = 110, .inertia = 400};
  Vec3 separation;
};
Scene moving_beads(double h) {
  Scene scene;
  scene.separation = (5 + h) * Vec3(1, 2, -2) / 3;
  scene.first.velocity = Vec3(0.1, 0.2, -0.05);
  scene.second.velocity = Vec3(-0.1, 0.1, 0.05);
  scene.first.angular_velocity = Vec3(0.02, -0.01, 0.03);
  scene.second.angular_velocity = Vec3(-0.01, 0.02, 0.01);
  return scene;
}
constexpr NearContactLaw usual{.viscosity = eta,
                               .range = {.normal = 0.6, .tangential = 0.5, .smallest = 0.002},
                               .stiffness_rate = 0.6,
                               .damping_ratio = 0.5,
                               .friction = 0.4};

TEST(NearContact, ConservesMomentumAndAngularMomentumAndTakesEnergy) {
  for (const double h : {0.3, 0.01, -0.1}) {
    const Scene scene = moving_beads(h);
    const auto& [first, second, separation] = scene;
    const PairImpulse p = near_contact_impulse(usual, first, second, separation, 1);
    const Vec3 turns = p.first_angular + p.second_angular + separation.cross(p.linear);
    EXPECT_LT(turns.norm(), 1e-14 * separation.norm() * p.linear.norm()) << "gap " << h;
    const auto energy = [](const CloseBead& bead, const Vec3& linear, const Vec3& angular) {
      return bead.velocity.dot(linear) + linear.squaredNorm() / (2 * bead.mass) +
             bead.angular_velocity.dot(angular) + angular.squaredNorm() / (2 * bead.inertia);
    };
    const double gained =
        energy(first, -p.linear, p.first_angular) + energy(second, p.linear, p.second_angular);
    EXPECT_LT(gained, -1e-3) << "gap " << h;
  }
}

// Catches a law that depends on the frame: a pair that turns as one body meets no resistance.
TEST(NearContact, LeavesARigidTurnAlone) {
  Scene scene = moving_beads(0.01);
  auto& [first, second, separation] = scene;
  const Vec3 turn(0.01, 0.02, -0.03), drift(0.1, 0, 0.2);
  first.velocity = drift;
  second.velocity = drift + turn.cross(separation);
  first.angular_velocity = second.angular_velocity = turn;
  const PairImpulse p = near_contact_impulse(usual, first, second, separation, 1);
  EXPECT_LT(p.linear.norm() + p.first_angular.norm() + p.second_angular.norm(), 1e-14);
}

/// Lets two spheres of radius 4, with the density of the fluid, approach each other with the relative
/// velocity v. Returns the gap after each step.
std::vector<double> head_on(const NearContactLaw& law, double h, double v, double step, double duration) {
  CloseBead bead{.radius = 4, .mass = 268, .inertia = 0.4 * 268 * 16};
  std::vector<double> gaps{h};
  for (double t = 0; t < duration; t += step) {
    CloseBead first = bead, second = bead;
    second.velocity = Vec3(v, 0, 0);
    const PairImpulse p = near_contact_impulse(law, first, second, Vec3(8 + h, 0, 0), step);
    const double end = v + p.linear[0] * 2 / bead.mass;
    h += step * 0.5 * (v + end);  // its impulse acts all the step long
    v = end;
    gaps.push_back(h);
  }
  return gaps;
}

// They come to rest where the film has taken all momentum, m v = Phi, whatever the step; Phi grows with
// ln(1/h). Catches a film that long steps jump through.
TEST(NearContact, StopsSpheresWhereTheFilmHasTakenTheirMomentum) {
  constexpr double v = 0.2, reduced_mass = 134;
  NearContactLaw law = usual;
  law.range.smallest = 1e-6;
  double rest = 0.6;
  while (-squeezing(4, 4, eta, law.range, rest).momentum < reduced_mass * v) rest *= 0.999;
  for (const double step : {0.01, 0.1, 1.0}) {
    const double end = head_on(law, 1, -v, step, 3000).back();
    EXPECT_NEAR(end / rest, 1, 0.7 * step + 0.01) << "step " << step << ", rests at " << rest;
  }
}

// Without a film they meet hard, at the speed limit: no deeper than they go in a step or so, then apart,
// slower.
TEST(NearContact, NeitherOverlapsDeeplyNorGainsSpeed) {
  NearContactLaw dry = usual;
  dry.range = {};
  for (const double v : {0.01, 0.1, 0.5, 1.0}) {
    const std::vector<double> gaps = head_on(dry, 0.37, -v, 1, 300 + 2 / v);
    EXPECT_GT(*std::ranges::min_element(gaps), -1.1 * v) << v;
    const double speed_after = gaps.back() - gaps[gaps.size() - 2];
    EXPECT_GT(speed_after, 0);
    EXPECT_LT(speed_after, 0.7 * v);
  }
}

// A bead that slides over another is slowed by at most mu times the normal impulse, and not beyond rest.
TEST(NearContact, RubsAsCoulombHasIt) {
  NearContactLaw dry = usual;
  dry.range = {};
  CloseBead first{.radius = 4, .mass = 268, .inertia = 0.4 * 268 * 16}, second = first;
  const Vec3 separation(7.9, 0, 0);
  for (const double slide : {0.3, 0.001}) {
    second.velocity = Vec3(-0.05, slide, 0);
    const PairImpulse p = near_contact_impulse(dry, first, second, separation, 1);
    const double normal = p.linear[0], friction = -p.linear[1];
    EXPECT_GT(normal, 0);
    // What stops the surfaces: a third and a half of the beads' mass, as they turn too.
    const double stop = slide / (2 / first.mass + 2 * 3.95 * 3.95 / first.inertia);
    EXPECT_NEAR(friction / std::min(stop, dry.friction * normal), 1, 1e-12) << slide;
  }
}

// In the step in which they come to touch, too: what stops them is contact, and rubs.
TEST(NearContact, RubsFromTheFirstTouch) {
  NearContactLaw dry = usual;
  dry.range = {};
  CloseBead first{.radius = 4, .mass = 268, .inertia = 0.4 * 268 * 16}, second = first;
  second.velocity = Vec3(-0.05, 0.5, 0);
  for (const double gap : {0.06, 0.04, 0.02, 0.001}) {
    const PairImpulse p = near_contact_impulse(dry, first, second, Vec3(8 + gap, 0, 0), 1);
    EXPECT_EQ(p.linear[0] > 0, gap < 0.05) << gap;
    EXPECT_NEAR(-p.linear[1], dry.friction * p.linear[0], 1e-12) << gap;
  }
}

/// Returns the change of velocity of a bead between twelve equal beads, which are at rest at equal distances
/// from it.
Vec3 change_in_crowd(const NearContactLaw& law, double distance, const Vec3& velocity) {
  const CloseBead neighbour{.radius = 4, .mass = 268, .inertia = 1715, .pairs = 12};
  CloseBead middle = neighbour;
  middle.velocity = velocity;
  Vec3 change = Vec3::Zero();
  for (int x = -1; x <= 1; ++x) {
    for (int y = -1; y <= 1; ++y) {
      for (int z = -1; z <= 1; ++z) {
        if (x * x + y * y + z * z != 2) continue;
        const Vec3 separation = distance * Vec3(x, y, z).normalized();
        change -= near_contact_impulse(law, middle, neighbour, separation, 1).linear / middle.mass;
      }
    }
  }
  return change;
}

// A bead pressed on from twelve sides at once, by films or by contact, comes to rest without turning back.
// Catches impulses that overshoot together.
TEST(NearContact, OfManyPairsAtOnceDoesNotOvershoot) {
  NearContactLaw sticky = usual, dry = usual;
  sticky.viscosity = 100;
  dry.range = {};
  dry.friction = 0;
  dry.stiffness_rate = 2;
  for (const auto& [law, distance] : {std::pair{sticky, 8.01}, {dry, 7.5}}) {
    const Vec3 start(0.1, 0.05, 0);
    Vec3 velocity = start;
    for (int n = 0; n < 100; ++n) {
      velocity += change_in_crowd(law, distance, velocity);
      EXPECT_GE(velocity.dot(start), -1e-9) << n;
    }
    EXPECT_LT(velocity.norm(), 1e-3);
  }
}

// Three beads in a row, pressed together by a force on either end: films that each know of the other let the
// ends approach with F/(their resistance), however thin they are. Catches a middle bead that yields to one
// neighbour after the other.
TEST(SwimmerContact, OfThreeBeadsIsSolvedAsAWhole) {
  constexpr double force = 0.5, heavy = 40;
  NearContactLaw law = usual;
  const std::array<Vec3, 3> positions{Vec3::Zero(), Vec3(4.01, 0, 0), Vec3(8.02, 0, 0)};
  std::array<CloseBead, 3> beads;
  beads.fill({.radius = 2, .mass = heavy, .inertia = 60});
  const double resistance = squeezing(2, 2, eta, law.range, 0.01).resistance;
  ASSERT_GT(resistance, 10 * heavy);
  std::array<Vec3, 3> velocity{Vec3(0.003, 0, 0), Vec3::Zero(), Vec3(-0.003, 0, 0)};
  for (int n = 0; n < 20; ++n) {
    for (int b = 0; b < 3; ++b) beads[b].velocity = velocity[b];
    beads[0].velocity[0] += force / heavy;
    beads[2].velocity[0] -= force / heavy;
    const SwimmerContact contact = swimmer_contact(law, beads, positions, 1);
    EXPECT_LT((contact.linear[0] + contact.linear[1] + contact.linear[2]).norm(), 1e-14);
    for (int b = 0; b < 3; ++b) velocity[b] = beads[b].velocity + contact.linear[b] / heavy;
  }
  // The film stiffens on the way of a step, of a tenth of the gap or so.
  EXPECT_NEAR(velocity[0][0] / (force / resistance), 1, 0.1);
  EXPECT_LT(std::abs(velocity[1][0]), 1e-12);
  EXPECT_NEAR(velocity[2][0], -velocity[0][0], 1e-12);
}

}  // namespace
}  // namespace beadswim
