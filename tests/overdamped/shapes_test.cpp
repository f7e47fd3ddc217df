#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "beadswim/compare/cycle_statistics.hpp"
#include "beadswim/theory/shaped_swimmer.hpp"
#include "scenes.hpp"

// Swimmers of other shapes than the paper's, moved without inertia, against symmetries and known formulas.

namespace beadswim {
namespace {

constexpr double period = 1000, omega = 2 * pi / period;

OverdampedScene lone(const SwimmerType& type, int steps_per_cycle) {
  OverdampedScene scene;
  scene.viscosity = 1.0 / 3;
  scene.types = {type};
  scene.swimmers = {{.id = 0, .type = 0, .position = {30, 40, 50}}};
  scene.step = type.driving.period / steps_per_cycle;
  scene.tolerance = 1e-12;
  return scene;
}

/// Returns the statistics of the last of `cycles` cycles.
CycleStatistics last_cycle(const OverdampedScene& scene, int cycles) {
  const Communicator world(MPI_COMM_WORLD);
  OverdampedSystem system(scene, world);
  const SwimmerType& type = scene.types[0];
  const int steps = static_cast<int>(std::lround(type.driving.period / scene.step));
  for (int n = 0; n < (cycles - 1) * steps; ++n) system.step();
  std::vector<SwimmerSample> samples;
  for (int n = 0;; ++n) {
    samples.push_back({system.time(), {system.positions().begin(), system.positions().end()}});
    if (n == steps) break;
    system.step();
  }
  EXPECT_FALSE(system.fault());
  return cycle_statistics(cycles, samples, type, scene.swimmers[0].orientation);
}

SwimmerType beads_at(const std::vector<Vec3>& places, double radius) {
  SwimmerType type;
  for (const Vec3& at : places) type.beads.push_back({{.radius = radius, .density = 1}, at});
  type.driving.period = period;
  return type;
}

void add_bond(SwimmerType& type, int i, int j, double stiffness) {
  type.bonds.push_back({{stiffness, (type.beads[j].at - type.beads[i].at).norm(), 0}, {i, j}});
}

/// Adds a harmonic to the rest length of a bond.
void drive_length(SwimmerType& type, int bond, double amplitude, double phase) {
  type.driving.bonds.push_back({.bond = bond,
                                .quantity = BondQuantity::rest_length,
                                .harmonics = {{.amplitude = amplitude, .phase = phase}}});
}

/// Returns five beads without symmetry, in a loop with a tail, driven by lengths, tensions, an angle and
/// forces that turn with the swimmer.
SwimmerType odd_shape() {
  SwimmerType type =
      beads_at({Vec3(0, 0, 0), Vec3(14, 3, -2), Vec3(10, 16, 4), Vec3(-4, 13, -3), Vec3(20, -8, 6)}, 3);
  type.beads[2].radius = 4;
  for (const auto& [i, j] : {std::pair{0, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 2}, {1, 4}, {0, 4}, {1, 3}, {3, 4}})
    add_bond(type, i, j, 0.3);
  type.angles = {{.beads = {0, 1, 4}, .stiffness = 20}};
  type.angles[0].rest = angle_at_rest(type, type.angles[0]);
  drive_length(type, 0, 1.5, 0.3);
  drive_length(type, 2, 2, 1.7);
  type.driving.bonds.push_back({.bond = 5, .harmonics = {{.amplitude = 0.2, .phase = 2.5, .multiple = 2}}});
  type.driving.angles = {{.angle = 0, .harmonics = {{.amplitude = 0.2, .phase = -1}}}};
  type.driving.frame = DrivingFrame::body;
  type.driving.forces = {{.bead = 0, .direction = Vec3::UnitY(), .harmonics = {{.amplitude = 0.1}}},
                         {.bead = 2, .direction = -Vec3::UnitY(), .harmonics = {{.amplitude = 0.1}}}};
  return type;
}

TEST(Shapes, ThatAreTurnedMoveAlikeInTheirNewOrientation) {
  const CycleStatistics plain = last_cycle(lone(odd_shape(), 100), 3);
  OverdampedScene turned_scene = lone(odd_shape(), 100);
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(2, Vec3(2, -1, 2) / 3).toRotationMatrix();
  turned_scene.swimmers[0].orientation = turn;
  const CycleStatistics turned = last_cycle(turned_scene, 3);
  EXPECT_GT(plain.velocity.norm() * period, 1e-2);
  EXPECT_LT((turned.velocity - turn * plain.velocity).norm(), 1e-9 * plain.velocity.norm());
  EXPECT_LT((*turned.angular_velocity - turn * *plain.angular_velocity).norm(),
            1e-9 * plain.angular_velocity->norm());
}

TEST(Shapes, ThatAreMirroredMoveAsInTheMirror) {
  const CycleStatistics plain = last_cycle(lone(odd_shape(), 100), 3);
  SwimmerType type = odd_shape();
  const Vec3 mirror(1, 1, -1);
  for (BeadAtRest& bead : type.beads) bead.at = bead.at.cwiseProduct(mirror);
  const CycleStatistics mirrored = last_cycle(lone(type, 100), 3);
  EXPECT_LT((mirrored.velocity - plain.velocity.cwiseProduct(mirror)).norm(), 1e-9 * plain.velocity.norm());
  EXPECT_LT((*mirrored.angular_velocity + plain.angular_velocity->cwiseProduct(mirror)).norm(),
            1e-9 * plain.angular_velocity->norm());
}

/// Returns four unequal beads at the corners of a tetrahedron, whose six edges have different phases.
SwimmerType tetrahedron() {
  SwimmerType type = beads_at({Vec3(0, 0, 0), Vec3(16, 0, 0), Vec3(7, 14, 0), Vec3(8, 5, 13)}, 3);
  type.beads[1].radius = 4;
  type.beads[3].radius = 2.5;
  for (const auto& [i, j] : {std::pair{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}}) {
    const int edge = static_cast<int>(type.bonds.size());
    add_bond(type, i, j, 0.3);
    drive_length(type, edge, 1.5 + 0.2 * edge, 1.3 * edge * edge);
  }
  return type;
}

/// Helical motion, by quantities that do not depend on the orientation in the box.
struct Helix {
  double turn = 0;    ///< rotation per period [radian]
  double pitch = 0;   ///< displacement per period along the axis of the rotation [length]
  double across = 0;  ///< displacement per period across this axis [length]
};

Helix helix_of(const Vec3& turn, const Vec3& displacement) {
  const Vec3 axis = turn.normalized();
  const double pitch = displacement.dot(axis);
  return {turn.norm(), pitch, (displacement - pitch * axis).norm()};
}

/// Returns the helix of the last two of `cycles` cycles, and requires that the statistics of one cycle have
/// the same. With the mean bead position c = o + E xi, where o and the rotation E(t) = exp(Omega t) belong to
/// the frame and xi is periodic with the mean 0, the displacement of the frame in a period, along its axes,
/// is the mean of E(-t) [c(t + T) - c(t)].
Helix helix_of(const OverdampedScene& scene, int cycles) {
  const Communicator world(MPI_COMM_WORLD);
  OverdampedSystem system(scene, world);
  const SwimmerType& type = scene.types[0];
  const int steps = static_cast<int>(std::lround(type.driving.period / scene.step));
  for (int n = 0; n < (cycles - 2) * steps; ++n) system.step();
  std::vector<SwimmerSample> samples;
  for (int n = 0; n <= 2 * steps; ++n) {
    samples.push_back({system.time(), {system.positions().begin(), system.positions().end()}});
    system.step();
  }
  const auto first = std::span(samples).first(steps + 1);
  const CycleStatistics statistics = cycle_statistics(cycles - 1, first, type, scene.swimmers[0].orientation);
  const Vec3 turn = *statistics.angular_velocity * period;
  const auto centre = [&](int n) -> Vec3 {
    Vec3 sum = Vec3::Zero();
    for (const Vec3& bead : samples[n].bead_positions) sum += bead / std::ssize(type.beads);
    return sum;
  };
  Vec3 displacement = Vec3::Zero();
  for (int n = 0; n < steps; ++n) {
    const Eigen::AngleAxisd back(-turn.norm() * n / steps, turn.normalized());
    displacement += back * (centre(n + steps) - centre(n)) / steps;
  }
  EXPECT_LT((statistics.velocity * period - displacement).norm(), 1e-6 * displacement.norm());
  return helix_of(turn, displacement);
}

/// Returns the largest difference of the helices, where angles count as displacements at the distance 10.
double farthest(const Helix& a, const Helix& b) {
  return std::max(
      {10 * std::abs(a.turn - b.turn), std::abs(a.pitch - b.pitch), std::abs(a.across - b.across)});
}

// Theory and the solver of swarms share the forces and the mobility of a pair, but neither the time
// integration nor the moving frame. The error of the solver is of third order in the time step h: relative to
// the displacement, a few times (omega h)^3.
TEST(Shapes, SwimOnTheHelixOfTheory) {
  SwimmerType odd = odd_shape();
  odd.angles.clear();  // with it, the springs could not all relax at time 0, as theory requires
  odd.driving.angles.clear();
  for (Bond& bond : odd.bonds) bond.stiffness = 3;  // so that the shape relaxes within the cycles before
  for (const SwimmerType& type : {tetrahedron(), odd}) {
    const ShapeMotion motion =
        periodic_motion({type, Eigen::Matrix3d::Identity(), 1.0 / 3}, rotne_prager_tensor);
    const Helix theory = helix_of(motion.angular_velocity * period, motion.velocity_vector * period);
    EXPECT_GT(std::min(theory.pitch, theory.across), 1e-3);
    const double coarse = farthest(helix_of(lone(type, 100), 8), theory);
    const double fine = farthest(helix_of(lone(type, 200), 8), theory);
    EXPECT_NEAR(coarse / fine, 8, 1.5);
    EXPECT_LT(fine, 3 * std::pow(2 * pi / 200, 3) * theory.across);
  }
}

/// Returns three equal beads in a line whose arms follow prescribed lengths: stiff bonds with driven rest
/// lengths of amplitude d. gamma omega/k = `softness`.
SwimmerType prescribed(double arm, double amplitude, double phase, double softness) {
  SwimmerType type = beads_at({Vec3(-arm, 0, 0), Vec3(0, 0, 0), Vec3(arm, 0, 0)}, 1);
  const double drag = 6 * pi / 3;
  for (int k = 0; k < 2; ++k) add_bond(type, k, k + 1, drag * omega / softness);
  drive_length(type, 0, amplitude, 0);
  drive_length(type, 1, amplitude, phase);
  return type;
}

// Far apart and at small amplitude, v = 7/24 a d^2 omega sin(phase)/l^2 (Golestanian and Ajdari, Phys. Rev. E
// 77 (2008) 036308); the first correction is of order a/l.
TEST(PrescribedStroke, TendsToTheFarFieldFormula) {
  constexpr double softness = 1e-5, phase = 1.2;
  std::vector<double> differences;
  for (const double arm : {20.0, 40.0, 80.0}) {
    const double amplitude = 0.01 * arm;
    const CycleStatistics cycle = last_cycle(lone(prescribed(arm, amplitude, phase, softness), 400), 3);
    EXPECT_NEAR(cycle.arm_amplitudes[0] / amplitude, 1, 1e-4);
    const double formula = 7.0 / 24 * amplitude * amplitude * omega * std::sin(phase) / (arm * arm);
    differences.push_back(std::abs(cycle.velocity.x()) / formula - 1);
  }
  EXPECT_LT(std::abs(differences[2]), 0.05);
  for (int fine = 1; fine < 3; ++fine) EXPECT_NEAR(differences[fine - 1] / differences[fine], 2, 0.25);
}

// Under forces -F(T - t), beads without springs return on the path along which the forces F(t) moved them.
TEST(FreeBeads, ReturnOnTheirPathUnderForcesReversedInTime) {
  SwimmerType type = beads_at({Vec3(0, 0, 0), Vec3(9, 1, 0), Vec3(2, 8, 3), Vec3(-3, 2, 9)}, 3);
  type.beads[1].radius = 2;
  for (int b = 0; b < 3; ++b) add_bond(type, b, b + 1, 0);
  type.driving.net_force = NetForce::allowed;
  for (int b = 0; b < 4; ++b)
    type.driving.forces.push_back({.bead = b,
                                   .direction = Vec3(1, b - 1.5, 0.3 * b * b - 1).normalized(),
                                   .constant = 0.01 * (b - 1),
                                   .harmonics = {{.amplitude = 0.1, .phase = 1.3 * b},
                                                 {.amplitude = 0.05, .phase = 0.4 * b, .multiple = 2}}});
  const auto positions_after_a_cycle = [](const SwimmerType& moved) {
    const Communicator world(MPI_COMM_WORLD);
    OverdampedSystem system(lone(moved, 8000), world);
    for (int n = 0; n < 8000; ++n) system.step();
    EXPECT_FALSE(system.fault());
    std::vector<Vec3> places(system.positions().begin(), system.positions().end());
    for (Vec3& place : places) place -= Vec3(30, 40, 50);
    return places;
  };
  SwimmerType back = type;
  const std::vector<Vec3> ends = positions_after_a_cycle(type);
  for (int b = 0; b < 4; ++b) {
    EXPECT_GT((ends[b] - type.beads[b].at).norm(), 0.1);
    back.beads[b].at = ends[b];
    back.driving.forces[b].constant *= -1;
    for (Harmonic& harmonic : back.driving.forces[b].harmonics) harmonic.phase *= -1;
  }
  const std::vector<Vec3> starts = positions_after_a_cycle(back);
  for (int b = 0; b < 4; ++b)
    EXPECT_LT((starts[b] - type.beads[b].at).norm(), 1e-9 * (ends[b] - type.beads[b].at).norm());
}

// A rod of twelve beads is towed by equal constant forces: its velocity is that of a rigid body with the
// Rotne-Prager mobility of its beads, along and across; slender bodies resist up to twice as much across.
TEST(TowedChain, MovesAsARigidRod) {
  std::vector<Vec3> places;
  for (int b = 0; b < 12; ++b) places.push_back(Vec3(2.2 * b, 0, 0));
  SwimmerType type = beads_at(places, 1);
  for (int b = 0; b < 11; ++b) add_bond(type, b, b + 1, 1e3);
  for (int b = 0; b < 10; ++b) type.angles.push_back({.beads = {b, b + 1, b + 2}, .stiffness = 1e5});
  type.driving.net_force = NetForce::allowed;
  constexpr double force = 0.01;
  std::array<double, 2> resistance{};
  for (const int axis : {0, 1}) {
    type.driving.forces.clear();
    for (int b = 0; b < 12; ++b)
      type.driving.forces.push_back({.bead = b, .direction = Vec3::Unit(axis), .constant = force});
    const CycleStatistics cycle = last_cycle(lone(type, 20), 2);
    resistance[axis] = 12 * force / cycle.velocity[axis];
    // Sum of the inverse of the matrix of mobilities along the axis: 1/(6 pi eta a), and for two beads at
    // distance r  (1/(8 pi eta r)) (1 + 1/3 (2 a^2)/r^2 ... along: 2 - 4/3 a^2/r^2 ..., across: 1 + 2/3
    // a^2/r^2.
    Eigen::MatrixXd mobility = Eigen::MatrixXd::Identity(12, 12) / (2 * pi);
    for (int i = 0; i < 12; ++i) {
      for (int j = 0; j < 12; ++j) {
        if (i == j) continue;
        const double r = 2.2 * std::abs(i - j);
        const double of_axis = axis == 0 ? 2 - 4 / (3 * r * r) : 1 + 2 / (3 * r * r);
        mobility(i, j) = 3 / (8 * pi * r) * of_axis;
      }
    }
    EXPECT_NEAR(resistance[axis] / mobility.inverse().sum(), 1, 1e-5);
  }
  EXPECT_GT(resistance[1] / resistance[0], 1.3);
  EXPECT_LT(resistance[1] / resistance[0], 2);
}

/// Returns a straight chain of beads, held at the distance `apart` by stiff springs, in shear flow
/// u_x = `rate` z.
OverdampedScene chain_in_shear(int beads, double apart, double rate, double step, int order) {
  std::vector<Vec3> places;
  for (int b = 0; b < beads; ++b) places.push_back(Vec3(apart * (b - 0.5 * (beads - 1)), 0, 0));
  SwimmerType type = beads_at(places, 1);
  for (int b = 0; b + 1 < beads; ++b) add_bond(type, b, b + 1, 1000);
  for (int b = 0; b + 2 < beads; ++b) type.angles.push_back({.beads = {b, b + 1, b + 2}, .stiffness = 1e4});
  OverdampedScene scene = lone(type, 1);
  scene.model = MobilityModel::multipole;
  scene.moment_order = order;
  scene.tolerance = 1e-10;
  scene.swimmers[0].position = {0, 0, 0.5};
  scene.flow.velocity_gradient(0, 2) = rate;
  scene.step = step;
  return scene;
}

/// Returns the time in which a chain turns by half a turn, from one crossing of the x axis to the next.
double half_turn(const OverdampedScene& scene) {
  const Communicator world(MPI_COMM_WORLD);
  OverdampedSystem system(scene, world);
  std::vector<double> crossings;
  double before = 0;
  while (crossings.size() < 2) {
    system.step();
    EXPECT_FALSE(system.fault());
    if (system.fault()) break;
    const double z = (system.positions().back() - system.positions().front()).z();
    if (z * before < 0 || (before == 0 && system.steps_done() == 1))
      crossings.push_back(system.time() - scene.step * z / (z - before));
    before = z;
  }
  return crossings.size() < 2 ? 0 : crossings[1] - crossings[0];
}

/// Returns B of a straight chain of unit spheres, which turns as by Jeffery with the parameter 1 - B. For a
/// pair, B = 16/3 (a/r)^5 far away (Batchelor & Green, J. Fluid Mech. 56 (1972) 375). A longer chain: every
/// pair contributes to the velocities across the chain; the forces that keep it straight have no sum and no
/// torque: B = x.R w/x.R x, where R is the inverse of Rotne and Prager's mobility across the chain.
double jeffery_defect(int beads, double apart) {
  Eigen::VectorXd x(beads), w = Eigen::VectorXd::Zero(beads);
  Eigen::MatrixXd mobility = Eigen::MatrixXd::Identity(beads, beads);  // times 6 pi eta a
  for (int i = 0; i < beads; ++i) x[i] = apart * (i - 0.5 * (beads - 1));
  for (int i = 0; i < beads; ++i) {
    for (int j = 0; j < beads; ++j) {
      if (i == j) continue;
      const double r = std::abs(x[i] - x[j]);
      w[i] += 16.0 / 3 / std::pow(r, 5) * (x[i] - x[j]) / 2;
      mobility(i, j) = 3 / (4 * r) * (1 + 2 / (3 * r * r));
    }
  }
  const Eigen::VectorXd Rx = mobility.inverse() * x;
  return Rx.dot(w) / Rx.dot(x);
}

// A rigid chain takes 2 pi/(rate sqrt(1 - (1 - B)^2)) for half a turn (Jeffery, Proc. R. Soc. A 102 (1922)
// 161). B leaves out reflections of flow between beads, of order (a/r)^3.
TEST(BackgroundFlow, ChainsTurnWithJefferysPeriod) {
  const double rate = 0.02, apart = 5;
  for (const int beads : {2, 3, 5}) {
    const double B = jeffery_defect(beads, apart);
    const double expected = 2 * pi / (rate * std::sqrt(1 - (1 - B) * (1 - B)));
    for (const int order : {1, 2}) {
      const double found = half_turn(chain_in_shear(beads, apart, rate, expected / 1500, order));
      EXPECT_NEAR(found / expected, 1, 4 / std::pow(apart, 3)) << beads << " beads, order " << order;
    }
  }
}

// The force presses the bead on the wall until the repulsion balances it: at half the range of the repulsion.
TEST(HalfSpaceRuns, ABeadThatIsPressedOnTheWallStopsAboveIt) {
  for (const int axis : {0, 2}) {
    SwimmerType type = beads_at({Vec3::Zero()}, 2);
    type.driving.forces = {{.bead = 0, .direction = -Vec3::Unit(axis), .constant = 0.3}};
    OverdampedScene scene = lone(type, 200);
    scene.domain.half_space = HalfSpace{axis};
    scene.swimmers[0].position = Vec3::Constant(2.5);
    const Communicator world(MPI_COMM_WORLD);
    OverdampedSystem system(scene, world);
    double before = system.positions()[0][axis];
    for (int n = 0; n < 2000; ++n) {
      system.step();
      EXPECT_LE(system.positions()[0][axis], before);
      before = system.positions()[0][axis];
    }
    EXPECT_FALSE(system.fault());
    constexpr double range = 0.2 * 2;  // of the gap between bead and mirror image
    EXPECT_NEAR(before - 2, range / 4, 1e-3);
    EXPECT_NEAR(system.state().smallest_gap, range / 4, 1e-3);
  }
}

// The first two steps, which are not steps of the backward difference formula, count too.
TEST(HalfSpaceRuns, TheSmallestGapIsThatAfterEachStepTowardsTheWall) {
  SwimmerType type = beads_at({Vec3::Zero()}, 2);
  type.driving.forces = {{.bead = 0, .direction = -Vec3::UnitZ(), .constant = 0.3}};
  OverdampedScene scene = lone(type, 200);
  scene.domain.half_space = HalfSpace{2};
  scene.swimmers[0].position = Vec3::Constant(2.18);
  const Communicator world(MPI_COMM_WORLD);
  OverdampedSystem system(scene, world);
  double before = system.state().smallest_gap;
  EXPECT_NEAR(before, 0.18, 1e-12);
  for (int n = 1; n <= 4; ++n) {
    system.step();
    const double gap = system.positions()[0].z() - 2, moved = before - gap;
    EXPECT_GT(moved, 0);
    EXPECT_NEAR(system.state().smallest_gap, gap, 0.05 * moved) << "step " << n;
    before = gap;
  }
}

}  // namespace
}  // namespace beadswim
