#include "beadswim/lattice/levels.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "beadswim/core/error.hpp"
#include "refined_fluid.hpp"
#include "taylor_green.hpp"

namespace beadswim::test {
namespace {

constexpr double pi = std::numbers::pi;
constexpr std::array all_periodic{Boundary::periodic, Boundary::periodic, Boundary::periodic};

/// Returns a cube of cells.
Block cube(int offset, int size) {
  return {.offset = Index3::Constant(offset), .size = Index3::Constant(size)};
}

/// Returns the error of a decaying vortex that drifts with the velocity `wind` in the periodic box `cells`,
/// with one refined level. The period of the vortex is n = cells[a].
RefinedFluid::Error vortex_error(const Index3& cells, const Block& refined, int a, int b,
                                 double relaxation_time, const Vec3& wind) {
  const double n = cells[a], speed = 0.5 / n;
  RefinedFluid fluid(cells, {refined}, relaxation_time, all_periodic);
  fluid.set([&](const Vec3& place) {
    CellMoments moments = taylor_green(speed, n, place, a, b);
    moments.momentum += wind;
    return moments;
  });
  const int steps = static_cast<int>(n * n / 8);
  fluid.steps(steps);
  const double decay = std::exp(-2 * lattice_viscosity(relaxation_time) * std::pow(2 * pi / n, 2) * steps);
  return fluid.error(
      [&](const Vec3& place) {
        return Vec3(decay * taylor_green(speed, n, place - steps * wind, a, b).momentum + wind);
      },
      speed * decay);
}

void expect_second_order(double coarse, double fine) {
  const double order = std::log2(coarse / fine);
  EXPECT_GT(order, 1.75) << coarse << " -> " << fine;
  EXPECT_LT(order, 2.5) << coarse << " -> " << fine;
}

// Speed and time step decrease as in taylor_green_test.cpp. The refined box spans the third axis. Catches
// populations copied without slopes (first order), a wrong relaxation time of a level and, in one of the
// planes, an axis that is treated differently.
TEST(Levels, VortexDecaysToSecondOrderInAllPlanes) {
  for (const auto& [a, b] : {std::pair{0, 1}, {1, 2}, {2, 0}}) {
    const int third = 3 - a - b;
    const auto error = [a = a, b = b, third](int n) {
      Index3 cells = Index3::Constant(n);
      Block refined = cube(n / 2 + n / 8, n);
      cells[third] = 4;
      refined.offset[third] = 0;
      refined.size[third] = 8;
      return vortex_error(cells, refined, a, b, 0.8, Vec3::Zero());
    };
    const auto coarse = error(16), middle = error(32), fine = error(64);
    expect_second_order(coarse.root_mean_square, middle.root_mean_square);
    expect_second_order(middle.root_mean_square, fine.root_mean_square);
    expect_second_order(coarse.largest, middle.largest);
    expect_second_order(middle.largest, fine.largest);
  }
}

// The vortex crosses faces, edges and corners of a cube. Catches a flow that the interface holds back.
TEST(Levels, VortexDriftsAcrossACubeToSecondOrder) {
  const auto error = [](int n) {
    return vortex_error(Index3::Constant(n), cube(n / 2, n), 0, 1, 0.53, Vec3(1.0, 0.5, 0.25) / n)
        .root_mean_square;
  };
  const std::array errors{error(12), error(24), error(48)};
  expect_second_order(errors[0], errors[1]);
  expect_second_order(errors[1], errors[2]);
}

/// Populations after collision of a steady linear flow u = G.x at density 1:
/// f*(x) = e(x) - (tau - 1) c.grad e, where e is the equilibrium at low speed.
void set_linear_flow(RefinedFluid& fluid, const Eigen::Matrix3d& gradient) {
  fluid.for_each_used_cell([&](const LevelCell& at) {
    Level& level = fluid.levels[at.level];
    const double edge = std::ldexp(1.0, -at.level), tau = 1 / level.rates.symmetric;
    for (int i = 0; i < d3q19::directions; ++i) {
      const Vec3 c = velocity_of(i);
      const Vec3 upstream = at.centre - (tau - 1) * edge * c;
      level.populations.set_outgoing(i, at.cell, 3 * d3q19::weight(i) * c.dot(gradient * upstream));
    }
  });
}

// Along faces every linear flow crosses the interface without error, whatever its direction. Edges are left
// out. Catches a wrong offset o, or one with the wrong sign, in either fine step.
TEST(Levels, LinearFlowCrossesFacesExactly) {
  constexpr double rate = 1e-11;  // so slow that the terms of second order in u are roundoff
  constexpr int n = 24, first = 8, last = 16;
  for (int entry = 0; entry < 8; ++entry) {
    Eigen::Matrix3d gradient = Eigen::Matrix3d::Zero();
    gradient(entry / 3, entry % 3) = rate;
    if (entry % 4 == 0) gradient(entry / 3 + 1, entry % 3 + 1) = -rate;  // no divergence
    RefinedFluid fluid(Index3::Constant(n), {cube(2 * first, 2 * (last - first))}, 0.7, all_periodic);
    set_linear_flow(fluid, gradient);
    fluid.steps(1);
    double largest = 0;
    fluid.for_each_used_cell([&](const LevelCell& at) {
      int near_faces = 0;  // number of axes along which the cell is next to the end of the refined box
      for (int a = 0; a < 3; ++a)
        near_faces += std::min(std::abs(at.centre[a] - first), std::abs(at.centre[a] - last)) < 2.5;
      const bool is_near_seam = (at.centre.array() < 3).any() || (at.centre.array() > n - 3).any();
      if (near_faces > 1 || is_near_seam) return;
      largest = std::max(largest, (fluid.moments(at).momentum - gradient * at.centre).norm());
    });
    EXPECT_LT(largest, 1e-7 * rate) << "du" << entry / 3 << "/dx" << entry % 3;
  }
}

// Plane Poiseuille flow between no-slip walls, driven by a body force, with a refined layer parallel to the
// walls and with a refined box between them. The profile is exact in uniform fluid. Catches a body force that
// is wrong on one level, and a layer that acts as a wall.
TEST(Levels, PoiseuilleFlowCrossesTheInterfaceToSecondOrder) {
  for (const bool is_layer : {true, false}) {
    const auto error = [&](int n) {
      Index3 cells(n, n, n);
      Block refined = cube(n / 2, n);
      if (is_layer) cells = {4, 4, n}, refined = {.offset = {0, 0, n / 2}, .size = {8, 8, n}};
      constexpr double tau = 1.0;
      RefinedFluid fluid(cells, {refined}, tau, {Boundary::periodic, Boundary::periodic, Boundary::no_slip});
      const double speed = 0.1 / n, viscosity = lattice_viscosity(tau);
      const auto profile = [&](const Vec3& place) {
        return Vec3(4 * speed * place[2] * (n - place[2]) / (n * n), 0, 0);
      };
      fluid.body_force[0] = 8 * speed * viscosity / (n * n) / 2;  // two fine steps in a coarse one
      fluid.set([&](const Vec3& place) { return CellMoments{0, profile(place)}; });
      fluid.steps(2 * n * n);
      return fluid.error(profile, speed).root_mean_square;
    };
    const std::array errors{error(12), error(24)};
    expect_second_order(errors[0], errors[1]);
  }
}

/// Returns the error of plane Couette flow between walls that move in opposite directions, after it has
/// become steady.
RefinedFluid::Error couette_error(const Index3& cells, const Block& refined, int across, int along) {
  constexpr double speed = 0.01;
  std::array<Boundary, 3> boundary = all_periodic;
  boundary[across] = Boundary::no_slip;
  RefinedFluid fluid(cells, {refined}, 1.0, boundary);
  const Vec3 velocity = speed * unit_vector(along).cast<double>().matrix();
  std::array<WallVelocities, 3> walls;
  walls[across] = {.lower = -velocity, .upper = velocity};
  fluid.levels.set_wall_velocities(walls);
  const int n = cells[across];
  const auto profile = [&](const Vec3& place) { return Vec3((2 * place[across] / n - 1) * velocity); };
  fluid.set([&](const Vec3& place) { return CellMoments{0, profile(place)}; });
  fluid.steps(2 * n * n);
  return fluid.error(profile, speed);
}

// The linear profile is exact with a refined layer parallel to the walls; the start leaves 3e-9. Catches an
// interface that slows down a shear flow, and a wall that moves at another velocity.
TEST(Levels, CouetteFlowCrossesALayerExactlyAndABoxToSecondOrder) {
  for (int across = 0; across < 3; ++across) {
    for (int along = 0; along < 3; ++along) {
      if (along == across) continue;
      Index3 cells = Index3::Constant(4);
      cells[across] = 16;
      Block layer{.offset = Index3::Zero(), .size = Index3::Constant(8)};
      layer.offset[across] = 8;
      layer.size[across] = 16;
      EXPECT_LT(couette_error(cells, layer, across, along).largest, 1e-8) << "xyz"[across] << "xyz"[along];
    }
    const int along = (across + 1) % 3;
    const auto error = [&](int n) {
      return couette_error(Index3::Constant(n), cube(n / 2, n), across, along).root_mean_square;
    };
    const std::array errors{error(12), error(24)};
    expect_second_order(errors[0], errors[1]);
  }
}

/// Fluid with random populations on three levels; the finest lies within the second one.
RefinedFluid random_fluid(bool spans, MPI_Comm comm = MPI_COMM_SELF, Precision precision = Precision::fp64) {
  Block middle{.offset = {6, 10, 12}, .size = {28, 24, 26}},
      finest{.offset = {24, 28, 34}, .size = {24, 20, 22}};
  if (spans) {
    middle.offset[2] = finest.offset[2] = 0;
    middle.size[2] = 36, finest.size[2] = 72;
  }
  return RefinedFluid(Index3(20, 20, 18), {middle, finest}, 0.6, all_periodic, precision, comm);
}
void disturb(RefinedFluid& fluid) {
  fluid.for_each_used_cell([&](const LevelCell& at) {
    for (int i = 0; i < d3q19::directions; ++i) {
      const double phase = 7 * i + at.centre.dot(Vec3(31, 57, 83)) + 11 * at.level;
      fluid.levels[at.level].populations.set_outgoing(i, at.cell, 1e-3 * std::sin(phase));
    }
  });
}

/// Returns mass and momentum of the fluid [coarsest cell].
Eigen::Vector4d totals(const RefinedFluid& fluid) {
  const CellMoments coarser = fluid.levels.sum_of_coarser(fluid.levels.coarser_totals(), fluid.communicator);
  const FluidTotals finest =
      sum_over_ranks(block_totals(fluid.levels.finest().populations), fluid.communicator);
  Eigen::Vector4d sum;
  sum << coarser.density_deviation + finest.density_deviation.value(),
      coarser.momentum + finest.momentum_value();
  return std::ldexp(1.0, -3 * (fluid.levels.count() - 1)) * sum;
}

// Also after steps in which the levels are not at the same time. Catches a population that is counted twice
// at an edge or a corner of a level, and lost or doubled momentum between two steps.
TEST(Levels, ConserveMassAndMomentumToRoundoff) {
  for (const bool spans : {true, false}) {
    RefinedFluid fluid = random_fluid(spans);
    disturb(fluid);
    const Eigen::Vector4d before = totals(fluid);
    for (int step = 0; step < 200; ++step) {
      fluid.levels.step(Vec3::Zero(), [](int, int) {});
      if (step >= 8) continue;
      EXPECT_LT((totals(fluid) - before).cwiseAbs().maxCoeff(), 1e-13) << step;
    }
    EXPECT_LT((totals(fluid) - before).cwiseAbs().maxCoeff(), 1e-13);
  }
}

// Catches an offset or slope that creates flow from nothing.
TEST(Levels, FluidAtRestStaysAtRest) {
  RefinedFluid fluid = random_fluid(false);
  fluid.set([](const Vec3&) { return CellMoments{1e-3, Vec3::Zero()}; });
  fluid.steps(50);
  fluid.for_each_used_cell([&](const LevelCell& at) {
    EXPECT_LT(std::abs(fluid.moments(at).density_deviation - 1e-3), 1e-16);
    EXPECT_LT(fluid.moments(at).momentum.norm(), 1e-16);
  });
}

// Catches a part of an interface that a rank does not receive, or sums in another order.
TEST(Levels, HaveTheSameBitsOnAnyNumberOfRanks) {
  for (const Precision precision : {Precision::fp64, Precision::fp32}) {
    RefinedFluid alone = random_fluid(false, MPI_COMM_SELF, precision),
                 shared = random_fluid(false, MPI_COMM_WORLD, precision);
    disturb(alone);
    disturb(shared);
    alone.steps(6);
    shared.steps(6);
    long cells = 0;
    shared.for_each_used_cell([&](const LevelCell& at) {
      const Level &ours = shared.levels[at.level], &all = alone.levels[at.level];
      const Vec3 local = at.centre * std::ldexp(1.0, at.level);
      const Index3 place = local.array().floor().cast<int>() - all.block.offset;
      const std::ptrdiff_t cell = all.populations.cell(place);
      for (int i = 0; i < d3q19::directions; ++i)
        ASSERT_EQ(ours.populations.outgoing(i, at.cell), all.populations.outgoing(i, cell));
      ++cells;
    });
    EXPECT_GT(cells, 0);
  }
}

// A refined box that lies across the seam of the periodic box equals the same box elsewhere. Catches refined
// cells that are found on one side of the seam only.
TEST(Levels, MayLieAcrossTheSeamOfAPeriodicBox) {
  const auto vortex = [](const Vec3& place) { return taylor_green(0.02, 16, place, 0, 1); };
  RefinedFluid inside(Index3::Constant(16), {cube(8, 16)}, 0.8, all_periodic),
      across(Index3::Constant(16), {{.offset = {-8, 24, 136}, .size = {16, 16, 16}}}, 0.8, all_periodic);
  inside.set([&](const Vec3& place) { return vortex(place - Vec3(8, 0, 0)); });  // shifted by half a period
  across.set([&](const Vec3& place) { return vortex(place - Vec3(0, 8, 0)); });
  inside.steps(20);
  across.steps(20);
  const auto sorted = [](const RefinedFluid& fluid) {
    std::vector<double> speeds;
    fluid.for_each_used_cell(
        [&](const LevelCell& at) { speeds.push_back(at.volume * fluid.moments(at).momentum.norm()); });
    std::ranges::sort(speeds);
    return speeds;
  };
  const std::vector<double> one = sorted(inside), other = sorted(across);
  ASSERT_EQ(one.size(), other.size());
  for (std::size_t n = 0; n < one.size(); ++n) EXPECT_NEAR(one[n], other[n], 1e-14);
}

/// Returns the largest density deviation that a pulse of sound leaves behind when it enters a refined layer,
/// relative to its height. `width`: standard deviation of the pulse [coarse cell].
double reflected(double width, double relaxation_time) {
  const auto pulse = [&](const Vec3& place) {
    const double height = 1e-6 * std::exp(-0.5 * std::pow((place[0] - 60) / width, 2));
    return CellMoments{height, Vec3(height / std::sqrt(3.0), 0, 0)};
  };
  const Index3 cells(240, 4, 4);
  RefinedFluid uniform(cells, {}, relaxation_time, all_periodic),
      refined(cells, {{.offset = {240, 0, 0}, .size = {160, 8, 8}}}, relaxation_time, all_periodic);
  uniform.set(pulse);
  refined.set(pulse);
  uniform.steps(180);
  refined.steps(180);
  double largest = 0;
  refined.for_each_used_cell([&](const LevelCell& at) {
    if (at.level > 0 || at.centre[0] > 100) return;
    largest = std::max(
        largest, std::abs(refined.moments(at).density_deviation - uniform.moments(at).density_deviation));
  });
  return largest / 1e-6;
}

// The pulse is 164 cells from the start when the reflected wave is compared. Catches an interface at which
// the speed of sound or the impedance changes.
TEST(Levels, SoundPassesTheInterface) {
  const double narrow = reflected(4, 0.55), wide = reflected(8, 0.55);
  EXPECT_LT(narrow, 2.5e-3);
  EXPECT_LT(wide, 1e-3);
  EXPECT_GT(wide, 1e-5);  // the pulse has passed
}

// The refined cube moves by two coarse cells along each axis, back and forth. Catches cells that take the
// stress of the wrong level, or lose mass or momentum.
TEST(Levels, KeepAFlowWhenTheyMove) {
  const auto error_and_loss = [](int n, bool moves) {
    const double speed = 0.5 / n, tau = 0.8;
    const auto vortex = [&](const Vec3& place) { return taylor_green(speed, n, place, 1, 2); };
    auto fluid =
        std::make_unique<RefinedFluid>(Index3::Constant(n), std::vector{cube(n / 2, n)}, tau, all_periodic);
    fluid->set(vortex);
    fluid->steps(n * n / 16);
    const Eigen::Vector4d before = totals(*fluid);
    for (const int shift : {4, 0}) {
      auto moved = std::make_unique<RefinedFluid>(Index3::Constant(n), std::vector{cube(n / 2 + shift, n)},
                                                  tau, all_periodic);
      transfer(fluid->levels, moved->levels, fluid->communicator);
      if (moves) fluid = std::move(moved);
    }
    const Eigen::Vector4d after = totals(*fluid);
    fluid->steps(n * n / 16);
    const double decay = std::exp(-2 * lattice_viscosity(tau) * std::pow(2 * pi / n, 2) * (n * n / 8));
    const double error =
        fluid->error([&](const Vec3& place) { return Vec3(decay * vortex(place).momentum); }, speed)
            .root_mean_square;
    return std::pair{error, (after - before).cwiseAbs().maxCoeff()};
  };
  const auto [still, none] = error_and_loss(32, false);
  const auto [moved, loss] = error_and_loss(32, true);
  EXPECT_LT(std::abs(moved / still - 1), 0.01);
  EXPECT_LT(loss, 1e-15);
}

// Levels that span a periodic axis, and then do not, and lie in other images of the box. Catches cells that
// keep what they had under a finer level of the former levels.
TEST(Levels, KeepMassAndFlowWhenTheySpanTheBoxNoLonger) {
  const auto flow = [](const Vec3& place) { return taylor_green(0.01, 20, place, 0, 1); };
  for (const bool spans_first : {true, false}) {
    RefinedFluid before = random_fluid(spans_first), after = random_fluid(!spans_first);
    before.set(flow);
    transfer(before.levels, after.levels, before.communicator);
    EXPECT_LT((totals(after) - totals(before)).cwiseAbs().maxCoeff(), 1e-13);
    EXPECT_LT(after.error([&](const Vec3& place) { return flow(place).momentum; }, 0.01).largest, 0.05);
  }
}

// Catches a level for which there is no room.
TEST(Levels, RefuseBoxesThatDoNotFit) {
  const auto make = [](const Block& refined, Boundary ends) {
    RefinedFluid(Index3::Constant(16), {refined}, 0.8, {ends, Boundary::periodic, Boundary::periodic});
  };
  EXPECT_THROW(make(cube(7, 16), Boundary::periodic), InputError);  // half a coarse cell
  EXPECT_THROW(make(cube(8, 15), Boundary::periodic), InputError);
  EXPECT_THROW(make(cube(2, 28), Boundary::periodic), InputError);  // too near to its image
  EXPECT_THROW(make(cube(4, 16), Boundary::no_slip), InputError);   // too near to a wall
  EXPECT_NO_THROW(make(cube(8, 16), Boundary::no_slip));
}

}  // namespace
}  // namespace beadswim::test
