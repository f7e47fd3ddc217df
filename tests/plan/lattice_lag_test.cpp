#include "beadswim/plan/lattice_lag.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace beadswim {
namespace {

/// Returns a swimmer like the single swimmer or the swarm's swimmer of the paper (Pickl et al. 2017):
/// viscosity 1/3, densities of fluid and beads 1.
CollinearSwimmer swimmer(double radius, double arm, double stiffness, double amplitude, double period) {
  return {.radius = {radius, radius, radius},
          .density = {1, 1, 1},
          .arm = {arm, arm},
          .stiffness = {stiffness, stiffness},
          .amplitude = {amplitude, amplitude},
          .phase = std::numbers::pi / 2,
          .period = period,
          .viscosity = 1.0 / 3};
}

Question question_in(const CollinearSwimmer& swimmer, const Vec3& lengths,
                     const std::array<Boundary, 3>& boundary = {}) {
  Question question(swimmer, 1);
  question.surroundings.box = BoxPlace{.box = {.lengths = lengths, .boundary = boundary},
                                       .middle_bead = {lengths[0] / 2, lengths[1] / 2, lengths[2] / 2}};
  return question;
}

Question swarm_cell() {
  return question_in(swimmer(6, 32, 0.2, 2, 2000), {96, 32, 32});
}

Question lone_swimmer() {
  return question_in(swimmer(4, 20, 0.0347, 0.2, 2000), {60, 40, 40});
}

MotionValues errors_of(const Question& question, const LatticeTiming& timing) {
  return LatticeLag(question).errors(timing);
}

/// Returns cell and time step of a lattice for viscosity 1/3 and this bead radius.
LatticeTiming timing(double radius, double cells_per_radius, double relaxation_time) {
  const double cell = radius / cells_per_radius, step = (relaxation_time - 0.5) * cell * cell;
  return {.step = step, .sound_speed = cell / step / std::numbers::sqrt3, .corrects_delay = true};
}

// Runs of docs/speed-against-error.md at long steps, where lag is most of the error: strokes to a fifteenth
// of it, and what cells alone make of them, 0.1 %, beside.
TEST(LatticeLag, IsWhatRunsWithLongStepsAreWrongBy) {
  struct Measured {
    Question question;
    double radius, cells, relaxation_time, d1, d2;
  };
  const std::array runs = std::to_array<Measured>({
      {swarm_cell(), 6, 4.5, 1.5, -0.0006, -0.0101},
      {swarm_cell(), 6, 4.5, 2, -0.0013, -0.0219},
      {swarm_cell(), 6, 4.5, 3, -0.0004, -0.0535},
      {swarm_cell(), 6, 3, 2, -0.0013, -0.0469},
      {swarm_cell(), 6, 3, 1, -0.0008, -0.0064},
      {lone_swimmer(), 4, 3, 2, -0.0065, -0.0092},
      {lone_swimmer(), 4, 3, 3, -0.0134, -0.0184},
      {lone_swimmer(), 4, 4, 1.5, -0.0022, -0.0032},
  });
  for (const Measured& run : runs) {
    const MotionValues lag = errors_of(run.question, timing(run.radius, run.cells, run.relaxation_time));
    constexpr double by_cells = 0.001, share = 1.0 / 15;
    EXPECT_NEAR(lag[1], run.d1, by_cells + share * std::abs(run.d1)) << run.relaxation_time;
    EXPECT_NEAR(lag[2], run.d2, by_cells + share * std::abs(run.d2)) << run.relaxation_time;
  }
}

// Velocities, which are second order: to a factor of two.
TEST(LatticeLag, BoundsWhatItDoesToTheVelocity) {
  const double swarm = errors_of(swarm_cell(), timing(6, 4.5, 1.5))[0];
  EXPECT_GT(swarm, 0.0356 / 2);
  EXPECT_LT(swarm, 0.0356 * 2);
  const double lone = errors_of(lone_swimmer(), timing(4, 3, 3))[0];
  EXPECT_GT(lone, 0.0364 / 2);
  EXPECT_LT(lone, 0.0364 * 2);
}

TEST(LatticeLag, FallsWithTheSquareOfTheResolution) {
  for (const Question& question : {swarm_cell(), lone_swimmer()}) {
    const double radius = question.line().radius[0];
    const double coarse = errors_of(question, timing(radius, 12, 1))[0];
    const double fine = errors_of(question, timing(radius, 24, 1))[0];
    EXPECT_NEAR(coarse / fine, 4, 0.05);
  }
}

// docs/method/force-delay.md: what the correction is for.
TEST(LatticeLag, IsLargerWithoutTheDelaysCorrection) {
  LatticeTiming plain = timing(4, 2, 1.5);
  const double with = errors_of(lone_swimmer(), plain)[2];
  plain.corrects_delay = false;
  EXPECT_LT(errors_of(lone_swimmer(), plain)[2], with - 0.008);
}

constexpr double sound_speed = 0.3;

TEST(SoundFlow, HasTheSlopeOfItsValue) {
  Question question = question_in(swimmer(6, 32, 0.2, 2, 2000), {100, 40, 50},
                                  {Boundary::free_slip, Boundary::periodic, Boundary::free_slip});
  question.surroundings.box->middle_bead = {46, 20, 21};
  InertialScene scene = inertial_scene(question);
  const SoundFlow flow = sound_flow(scene, question.surroundings.box, sound_speed);
  constexpr double shift = 1e-4;
  const auto moved = [&](double by) {
    InertialScene other = scene;
    other.positions[2] += by;
    return sound_flow(other, question.surroundings.box, sound_speed).value(2, 0);
  };
  const std::complex<double> slope = (moved(shift) - moved(-shift)) / (2 * shift);
  EXPECT_LT(std::abs(slope - flow.by_receiver(2, 0)), 1e-6 * std::abs(slope));
}

// A wall is a mirror: across y as the sum of two periodic boxes' lines, which is a box of half the length.
TEST(SoundFlow, SeesWallsAsMirrors) {
  const CollinearSwimmer shape = swimmer(6, 32, 0.2, 2, 2000);
  const Question walled =
      question_in(shape, {100, 40, 40}, {Boundary::periodic, Boundary::free_slip, Boundary::periodic});
  const Question periodic = question_in(shape, {100, 40, 40});  // in the middle: copies are a box apart
  const SoundFlow a = sound_flow(inertial_scene(walled), walled.surroundings.box, sound_speed);
  const SoundFlow b = sound_flow(inertial_scene(periodic), periodic.surroundings.box, sound_speed);
  EXPECT_LT((a.value - b.value).norm(), 1e-3 * b.value.norm());
}

// A bead's own flow in a large box is that of open space, friction 6 pi eta a (1 - i omega nu/(2 c^2)).
TEST(SoundFlow, OfABeadAlone) {
  const CollinearSwimmer shape = swimmer(4, 20, 0.0347, 0.2, 2000);
  Question open = question_in(shape, {400, 400, 400});
  open.surroundings.box.reset();
  const double omega = shape.angular_frequency();
  const double own = omega / (12 * std::numbers::pi * 4 * sound_speed * sound_speed);
  const SoundFlow flow = sound_flow(inertial_scene(open), std::nullopt, sound_speed);
  EXPECT_NEAR(flow.value(0, 0).imag() / own, 1, 1e-6);
  const Question boxed = question_in(shape, {400, 400, 400});
  const SoundFlow in_box = sound_flow(inertial_scene(boxed), boxed.surroundings.box, 3.0);
  EXPECT_NEAR(in_box.value(0, 0).imag() / (own / 100), 1, 0.03);
}

}  // namespace
}  // namespace beadswim
