#include <gtest/gtest.h>

#include <utility>

#include "beadswim/lattice/populations.hpp"
#include "beadswim/swimmers/swimmer_forces.hpp"
#include "scenes.hpp"

// Energy balances of a driven swimmer:
//
//   beads   W = W_fluid + D_dashpots + change of (elastic + kinetic energy of the beads)
//   fluid   W_fluid = D_fluid + change of the kinetic energy of the fluid
//
//   W          work of the driving forces;  W_fluid = -sum of int (F_h.U + T_h.Omega) dt over the beads, the
//              work of the beads on the fluid (F_h, T_h force and torque of the fluid; U, Omega velocities)
//   D_dashpots = int c (dL/dt)^2 dt;  D_fluid = int 2 rho nu S:S dV dt, S strain rate

namespace beadswim::test {
namespace {

/// Energies of one or several steps [lattice units].
struct Energies {
  double driving = 0;      ///< W
  double on_fluid = 0;     ///< W_fluid
  double dashpots = 0;     ///< D_dashpots
  double dissipation = 0;  ///< D_fluid
};

/// Stored energies at one time [lattice units].
struct Stored {
  double beads = 0;  ///< elastic and kinetic energy
  double fluid = 0;  ///< kinetic energy
};

Vec3 arm(const SwimmerMotion& motion, int k) {
  return motion[k + 1].position - motion[k].position;
}

/// Returns 2 nu S:S, the dissipation per volume at density 1, from the populations after the collision: their
/// second moments minus those of the equilibrium are -2/3 (tau - 1) S.
double dissipation(const Populations& populations, std::ptrdiff_t cell, double relaxation_time) {
  const auto [r, u] = cell_moments(populations, cell);
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
  for (int i = 0; i < d3q19::directions; ++i) {
    const Vec3 c = velocity_of(i);
    second += (populations.outgoing(i, cell) - equilibrium(i, r, u[0], u[1], u[2])) * c * c.transpose();
  }
  return 2 * lattice_viscosity(relaxation_time) * (second / (-2.0 / 3 * (relaxation_time - 1))).squaredNorm();
}

/// Calls visit(cell index) for all cells that no bead covers.
void for_each_fluid_cell(const CoupledSystem& system, auto&& visit) {
  for_each_cell(system.levels().finest().populations, [&](const Index3& p, std::ptrdiff_t cell) {
    if (!system.coverage().is_covered(p[0], p[1], p[2])) visit(cell);
  });
}

Stored stored(const CoupledSystem& system) {
  Stored energy;
  const SwimmerState& swimmer = system.owned_swimmers()[0];
  const SwimmerType& type = system.scene().types[0];
  for (int b = 0; b < 3; ++b) {
    const BeadMotion& bead = swimmer.motion[b];
    energy.beads += mass(type.beads[b]) / 2 * bead.velocity.squaredNorm() +
                    moment_of_inertia(type.beads[b]) / 2 * bead.angular_velocity.squaredNorm();
  }
  for (int k = 0; k < 2; ++k) {
    const double extension = arm(swimmer.motion, k).norm() - type.bonds[k].rest_length;
    energy.beads += type.bonds[k].stiffness / 2 * extension * extension;
  }
  for_each_fluid_cell(system, [&](std::ptrdiff_t cell) {
    energy.fluid += cell_moments(system.levels().finest().populations, cell).momentum.squaredNorm() / 2;
  });
  return energy;
}

/// Advances the system by one step and returns the energies of this step.
Energies step(CoupledSystem& system) {
  const SwimmerType& type = system.scene().types[0];
  const SwimmerState before = system.owned_swimmers()[0];
  const double time = system.steps_done() + 0.5;
  system.step();
  const SwimmerState& after = system.owned_swimmers()[0];
  Energies energy;
  BeadVectors middle(3, 3);
  for (int b = 0; b < 3; ++b) middle.col(b) = (before.motion[b].position + after.motion[b].position) / 2;
  const BeadVectors driving = driving_forces(type, time, middle, after.orientation_at_start());
  for (int b = 0; b < 3; ++b) {
    const Vec3 moved = after.motion[b].position - before.motion[b].position;
    const Vec3 turned = (before.motion[b].angular_velocity + after.motion[b].angular_velocity) / 2;
    energy.driving += driving.col(b).dot(moved);
    energy.on_fluid -= (before.last_impulse[b].force + after.last_impulse[b].force).dot(moved) / 2 +
                       (before.last_impulse[b].torque + after.last_impulse[b].torque).dot(turned) / 2;
  }
  for (int k = 0; k < 2; ++k) {
    const double rate = arm(after.motion, k).norm() - arm(before.motion, k).norm();
    energy.dashpots += type.bonds[k].damping * rate * rate;
  }
  for_each_fluid_cell(system, [&](std::ptrdiff_t cell) {
    energy.dissipation +=
        dissipation(system.levels().finest().populations, cell, system.scene().relaxation_time);
  });
  return energy;
}

struct Case {
  BeadScheme scheme;
  double radius;     ///< of the beads [cell]
  double tolerance;  ///< relative, of the fluid's balance
};
class EnergyBalance : public testing::TestWithParam<Case> {};
// The dissipation is that of whole cells outside the beads, of first order at their surfaces.
INSTANTIATE_TEST_SUITE_P(Boundaries, EnergyBalance,
                         testing::Values(Case{BeadScheme::mr, 3, 0.015}, Case{BeadScheme::mr, 4.5, 0.01},
                                         Case{BeadScheme::cli, 3, 0.09}, Case{BeadScheme::cli, 4.5, 0.06}));

// The work of the driving forces is found again in dashpots, springs, the motion of beads and fluid, and
// heat.
TEST_P(EnergyBalance, ClosesOverHalfACycle) {
  const auto [scheme, radius, tolerance] = GetParam();
  const Communicator self(MPI_COMM_SELF);
  const int width = static_cast<int>(6 * radius);
  CoupledScene scene = small_swimmer(Index3(2 * width, width, width),
                                     Vec3(width + 0.15, width / 2 + 0.45, width / 2 + 0.05), Vec3::UnitX());
  const double scale = radius / 3;
  const int cycle = static_cast<int>(400 * scale * scale);
  change(scene.types[0], [&, radius = radius](ThreeBeadSwimmer& type) {
    type.beads.fill({.radius = radius, .density = 2});
    type.springs.fill({.stiffness = 0.05 * scale, .rest_length = 3.5 * radius, .damping = 1});
    type.driving.amplitude = {0.15 * scale * scale, 0.15 * scale * scale};
    type.driving.period = cycle;
  });
  scene.relaxation_time = 1.5;
  scene.bead_boundary = scheme;
  CoupledSystem system(scene, self);
  advance(system, cycle / 4);  // the balances need no steady state
  const Stored first = stored(system);
  Energies sum;
  for (int n = 0; n < cycle / 2; ++n) {
    const Energies one = step(system);
    sum.driving += one.driving;
    sum.on_fluid += one.on_fluid;
    sum.dashpots += one.dashpots;
    sum.dissipation += one.dissipation;
  }
  const Stored last = stored(system);
  const double beads = sum.on_fluid + sum.dashpots + last.beads - first.beads;
  const double fluid = sum.dissipation + last.fluid - first.fluid;
  EXPECT_NEAR(beads / sum.driving, 1, 3e-5);  // the time step squared
  EXPECT_NEAR(fluid / sum.on_fluid, 1, tolerance);
  EXPECT_GT(sum.dashpots, 0.01 * sum.driving);  // no term is negligible
  EXPECT_GT(std::abs(last.beads - first.beads), 0.01 * sum.driving);
}

}  // namespace
}  // namespace beadswim::test
