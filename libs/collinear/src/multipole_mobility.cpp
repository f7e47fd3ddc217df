#include "beadswim/collinear/multipole_mobility.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "beadswim/core/dense_systems.hpp"
#include "beadswim/core/error.hpp"
#include "multipole_line.hpp"

namespace beadswim {

namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using multipole::Line;

/// Linear system matrix * own = drive for the multipole coefficients `own` of the flows that the spheres
/// cause (own flows, multipole_line.hpp). In column k of `own` and `drive`, sphere k moves at unit velocity
/// and all other spheres are at rest.
struct System {
  MatrixXd matrix;  ///< identity minus the responses of spheres to the flows of other spheres
  MatrixXd drive;   ///< coefficients of the own flow of the moving sphere if it were alone
  std::vector<std::vector<MatrixXd>> translation{};  ///< matrices T of multipole::translation()
};

struct Solution {
  MatrixXd own;      ///< coefficients A_n and B_n of all spheres; one column per moving sphere
  MatrixXd adjoint;  ///< column i: derivatives of A_0 of sphere i by the rows of drive; last: of stresslet()
};

void check_positive(double number, const std::string& name) {
  if (!(number > 0) || !std::isfinite(number)) {
    throw InputError(name, "the value {} is invalid: a finite number greater than 0 is needed", number);
  }
}

void check_line(std::span<const double> radii, std::span<const double> positions) {
  if (radii.empty() || radii.size() != positions.size()) {
    throw InputError("spheres on a line",
                     "there are {} radii and {} positions of spheres; give one position per radius, and at "
                     "least one sphere",
                     radii.size(), positions.size());
  }
  for (std::size_t i = 0; i < radii.size(); ++i) {
    check_positive(radii[i], fmt::format("radius of sphere {}", i + 1));
    if (i == 0) continue;
    const double distance = positions[i] - positions[i - 1], touching = radii[i] + radii[i - 1];
    if (!(distance > touching) || !std::isfinite(distance)) {
      throw InputError(fmt::format("spheres {} and {}", i, i + 1),
                       "the centres of the two spheres are {} apart; the distance must be above {}, where "
                       "the spheres touch",
                       distance, touching);
    }
  }
}

System assemble(const Line& line) {
  System system{.matrix = MatrixXd::Identity(line.unknowns(), line.unknowns()),
                .drive = MatrixXd::Zero(line.unknowns(), line.size())};
  system.translation.resize(line.size(), std::vector<MatrixXd>(line.size()));
  for (int i = 0; i < line.size(); ++i) {
    // A lone sphere that moves at unit velocity causes the flow A_0 = -3/4, B_1 = 1/4.
    system.drive(line.start[i], i) = -0.75;
    system.drive(line.start[i] + line.order[i], i) = 0.25;
    for (int j = 0; j < line.size(); ++j) {
      if (j == i) continue;
      const multipole::Pair pair = line.pair(i, j);
      system.translation[i][j] = multipole::translation(pair);
      system.matrix.block(line.start[i], line.start[j], line.unknowns(i), line.unknowns(j)) =
          -multipole::response(line.order[i], multipole::unit_flows(pair, system.translation[i][j]));
    }
  }
  return system;
}

// A sphere of radius a causes -(3 cos^2 theta - 1) A_1 a^2/r^2 e_r by A_1 and B_0 = -A_1 (r in [length]).
// Multiplied by -8 pi eta, the sum of a^2 A_1 over the spheres is their axial stresslet.
VectorXd stresslet(const Line& line) {
  VectorXd weights = VectorXd::Zero(line.unknowns());
  for (int i = 0; i < line.size(); ++i) weights[line.start[i] + 1] = line.radius[i] * line.radius[i];
  return weights;
}

Solution solve(const Line& line, const System& system) {
  MatrixXd strengths = MatrixXd::Zero(line.unknowns(), line.size() + 1);
  for (int i = 0; i < line.size(); ++i) strengths(line.start[i], i) = 1;
  strengths.rightCols<1>() = stresslet(line);
  const PairedSolutions solutions = solve_both(system.matrix, system.drive, strengths);
  return {.own = solutions.direct, .adjoint = solutions.transposed};
}

/// Returns -8 pi eta a for each sphere of radius a in a fluid of dynamic viscosity eta. This factor times the
/// multipole coefficient A_0 of the sphere is the force of the sphere on the fluid.
VectorXd force_per_strength(const Line& line, double viscosity) {
  const Eigen::Map<const VectorXd> radius(line.radius.data(), line.size());
  return -8 * std::numbers::pi * viscosity * radius;
}

MatrixXd symmetric_part(const MatrixXd& matrix) {
  return (matrix + matrix.transpose()) / 2;
}

/// Returns the mobility mu = R^-1 [time/mass]. The element R_ik of the resistance is the force of sphere i on
/// the fluid if sphere k moves at unit velocity and all other spheres are at rest.
MatrixXd mobility_of(const Line& line, const Solution& flow, const VectorXd& force) {
  MatrixXd resistance(line.size(), line.size());
  for (int i = 0; i < line.size(); ++i) resistance.row(i) = force[i] * flow.own.row(line.start[i]);
  return symmetric_part(inverse(resistance));
}

/// Returns the derivatives of A_0 of all spheres and of stresslet() (rows) by the offset of the
/// centres, position of `receiver` minus position of `source`. In column k, sphere k moves at unit velocity.
MatrixXd strength_slope(const Line& line, const System& system, const Solution& flow, int receiver,
                        int source) {
  const MatrixXd own = flow.own.middleRows(line.start[source], line.unknowns(source));
  const multipole::IncomingFlow slopes =
      multipole::flow_slopes(line.pair(receiver, source), system.translation[receiver][source], own);
  return flow.adjoint.middleRows(line.start[receiver], line.unknowns(receiver)).transpose() *
         multipole::response(line.order[receiver], slopes);
}

std::vector<MatrixXd> strength_slopes(const Line& line, const System& system, const Solution& flow) {
  std::vector<MatrixXd> slopes(line.size(), MatrixXd::Zero(line.size() + 1, line.size()));
  for (int i = 0; i < line.size(); ++i) {
    for (int j = 0; j < line.size(); ++j) {
      if (j == i) continue;
      const MatrixXd slope = strength_slope(line, system, flow, i, j);
      slopes[i] += slope;
      slopes[j] -= slope;
    }
  }
  return slopes;
}

/// Returns the mobility with d mu / d x_k = -mu (d R / d x_k) mu and sigma = s mu. R: resistance; s:
/// stresslet if sphere k moves at unit velocity; x_k: position of sphere k.
MultipoleMobility with_slopes(const Line& line, const System& system, const Solution& flow,
                              const MatrixXd& mobility, const VectorXd& force, double viscosity) {
  const double per_strength = -8 * std::numbers::pi * viscosity;
  const VectorXd moving = per_strength * flow.own.transpose() * stresslet(line);
  MultipoleMobility result{.value = mobility,
                           .slope = {},
                           .stresslet = mobility * moving,
                           .stresslet_slope = MatrixXd(line.size(), line.size()),
                           .order = std::ranges::max(line.order)};
  for (const MatrixXd& slope : strength_slopes(line, system, flow)) {
    const Eigen::Index k = std::ssize(result.slope);
    result.slope.push_back(
        symmetric_part(-mobility * force.asDiagonal() * slope.topRows(line.size()) * mobility));
    result.stresslet_slope.col(k) =
        result.slope[k] * moving + per_strength * mobility * slope.bottomRows<1>().transpose();
  }
  return result;
}

/// Returns an upper bound of the truncation error of the coefficient A_0 of each sphere (rows), if sphere k
/// moves at unit velocity (column k). The multipoles of order n contribute adjoint_n * own_n to A_0, which
/// decays as exp(-2 n xi). The error is bounded by the geometric series that continues the last computed
/// orders. Signs are ignored, so this series is about 50 times the true error of the mobility mu.
///
/// The derivatives of mu by the positions have a larger error: by a factor 2 n d(xi)/dR, where R is the
/// distance of the centres. The series is therefore multiplied by 10. In tests with 300 random lines of
/// spheres, this bound was at least 4 times the error of the derivatives.
MatrixXd strength_error(const Line& line, const Solution& flow) {
  constexpr int last = 2;  // one odd and one even order of A_n and of B_n
  constexpr double for_slopes = 10;
  MatrixXd error = MatrixXd::Zero(line.size(), line.size());
  for (int i = 0; i < line.size(); ++i) {
    const double series = for_slopes / std::expm1(2 * nearest_bispherical_coordinate(line, i));
    for (const int end : {line.start[i] + line.order[i], line.start[i + 1]}) {
      const MatrixXd adjoint = flow.adjoint.middleRows(end - last, last).leftCols(line.size()).cwiseAbs();
      error += series * adjoint.transpose() * flow.own.middleRows(end - last, last).cwiseAbs();
    }
  }
  return error;
}

/// Returns the largest error of an element mu_ij of the mobility relative to sqrt(mu_ii mu_jj), for given
/// errors of the resistance matrix mu^-1.
double relative_error(const MatrixXd& mobility, const MatrixXd& resistance_error) {
  const MatrixXd error = mobility.cwiseAbs() * resistance_error * mobility.cwiseAbs();
  const VectorXd root = mobility.diagonal().cwiseSqrt();
  return (error.array() / (root * root.transpose()).array()).maxCoeff();
}

}  // namespace

MultipoleMobility multipole_mobility(std::span<const double> radii, std::span<const double> positions,
                                     double viscosity, double tolerance) {
  check_line(radii, positions);
  check_positive(viscosity, "viscosity");
  check_positive(tolerance, "tolerance");
  for (double log_tolerance = std::log(tolerance);;) {
    const Line line = multipole::make_line(radii, positions, log_tolerance);
    const VectorXd force = force_per_strength(line, viscosity);
    const System system = assemble(line);
    const Solution flow = solve(line, system);
    const MatrixXd mobility = mobility_of(line, flow, force);
    const double error = relative_error(mobility, force.cwiseAbs().asDiagonal() * strength_error(line, flow));
    if (error <= tolerance) return with_slopes(line, system, flow, mobility, force, viscosity);
    if (!std::isfinite(error))
      throw NotFiniteError(
          "the mobility of spheres on a line is not finite; check the radii, the positions and the "
          "viscosity");
    log_tolerance -= std::log(error / tolerance) + 1;  // ratio of error and tolerance, and a margin of e
  }
}

}  // namespace beadswim
