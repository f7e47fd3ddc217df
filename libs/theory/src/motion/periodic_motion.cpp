#include "beadswim/theory/periodic_motion.hpp"

#include <fmt/core.h>

#include <Eigen/LU>
#include <algorithm>
#include <complex>
#include <optional>

#include "beadswim/collinear/pair_mobility.hpp"
#include "beadswim/core/dense_systems.hpp"
#include "beadswim/core/error.hpp"
#include "beadswim/core/setting.hpp"
#include "beadswim/core/trigonometric_nodes.hpp"
#include "beadswim/theory/linear_response.hpp"

namespace beadswim {

namespace {

using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// Motion at the nodes (columns): change of the length of arm 1, displacement of bead 2, change of the length
/// of arm 2 [length]. The changes of the arms are unknowns instead of the displacements of beads 1 and 3.
/// With these displacements, the tension of a stiff spring would lose significance in the difference of two
/// positions.
using NodalMotion = NodalValues;

/// Returns the matrix that maps a column of NodalMotion to the displacements of the three beads [length].
Matrix3d beads_from_motion() {
  Matrix3d beads;
  // clang-format off
  beads << -1, 1, 0,
            0, 1, 0,
            0, 1, 1;
  // clang-format on
  return beads;
}

/// Returns the column of NodalMotion for bead displacements p.
Vector3d motion_of_beads(const Vector3d& p) {
  return {p[1] - p[0], p[1], p[2] - p[1]};
}

/// Equations of motion of one swimmer on one set of nodes (symbols: periodic_motion.hpp). At each node,
///
///   omega Z dq + K q + omega C dq = g,    sum_k w_k (dp_k + V/omega) = 0
///
///   Z   = (D mu D^T)^-1, tensions of the arms per arm rate [mass/time]
///   g   tensions of the arms by the driving, F = D^T g [mass length/time^2]
///   q   changes of the lengths of the two arms [length]
///   p   displacements of the three beads [length]
///   d   derivative with respect to omega t, so that dq, dp and V/omega are lengths
///
/// Each row of the first equation balances the tensions of one arm. Roundoff of a stiff spring therefore does
/// not affect the equation of a soft spring.
class HarmonicBalance {
 public:
  HarmonicBalance(const CollinearSwimmer& swimmer, const LinePositions& rest,
                  const MobilityFunction& mobility, int nodes)
      : mobility_(mobility),
        rest_(Eigen::Map<const Vector3d>(rest.data())),
        nodes_(nodes),
        omega_(swimmer.angular_frequency()),
        derivative_(differentiation_matrix(nodes)),
        stiffness_(swimmer.stiffness[0], swimmer.stiffness[1]),
        damping_(omega_ * swimmer.damping[0], omega_ * swimmer.damping[1]),
        driving_(driving_tensions(swimmer)) {
    for (int arm = 0; arm < 2; ++arm) {
      const double drag = omega_ / self_mobility(swimmer.radius[1], swimmer.viscosity);
      row_scale_[arm] = 1 / (stiffness_[arm] + damping_[arm] + drag);
    }
  }

  LinePositions places(const NodalMotion& motion, int node) const {
    const Vector3d x = rest_ + beads_ * motion.col(node);
    return {x[0], x[1], x[2]};
  }

  NodalMotion rates(const NodalMotion& motion) const { return motion * derivative_.transpose(); }

  /// Returns the vector that Newton's method subtracts from the unknowns (motion, V/omega), if the driving
  /// forces are multiplied by `driving`.
  VectorXd newton_step(const NodalMotion& motion, double velocity, double driving) const {
    const int unknowns = 3 * nodes_ + 1;
    const NodalMotion rate = rates(motion);
    MatrixXd jacobian = MatrixXd::Zero(unknowns, unknowns);
    VectorXd residual = VectorXd::Zero(unknowns);
    for (int n = 0; n < nodes_; ++n) {
      const NodeEquations node = equations(motion, rate, velocity, driving * driving_tension(n), n);
      residual.segment<3>(3 * n) = node.residual;
      for (int m = 0; m < nodes_; ++m) jacobian.block<3, 3>(3 * n, 3 * m) = derivative_(n, m) * node.by_rate;
      jacobian.block<3, 3>(3 * n, 3 * n) += node.by_motion;
      jacobian(3 * n + 2, unknowns - 1) = 1;
      // The last equation fixes the mean of the displacement over beads and nodes at zero.
      jacobian.block<1, 3>(unknowns - 1, 3 * n) = beads_.colwise().sum() / nodes_;
    }
    residual[unknowns - 1] = (beads_ * motion).sum() / nodes_;
    return solve(jacobian, residual);
  }

  /// Returns the mobilities at all nodes.
  std::vector<CollinearMobility> mobilities(const NodalMotion& motion) const {
    std::vector<CollinearMobility> mobilities;
    for (int n = 0; n < nodes_; ++n) mobilities.push_back(mobility_(places(motion, n)));
    return mobilities;
  }

  /// Returns the mean of sum_i (x_i + sigma_i) F_i, F = D^T g: the stresslets sigma.F of the beads are those
  /// of `mobilities`, g are the tensions of the arms.
  double mean_dipole(const NodalMotion& motion, const std::vector<CollinearMobility>& mobilities) const {
    const NodalMotion rate = rates(motion);
    double sum = 0;
    for (int n = 0; n < nodes_; ++n) {
      const Eigen::Vector2d q(motion(0, n), motion(2, n)), dq(rate(0, n), rate(2, n));
      const Eigen::Vector2d levers = arm_rates() * (rest_ + mobilities[n].stresslet) + q;
      sum += levers.dot(driving_tension(n) - stiffness_.cwiseProduct(q) - damping_.cwiseProduct(dq));
    }
    return sum / nodes_;
  }

  /// Returns the velocity V = -<sum_k (w_k(x) - w_k(X)) dp_k/dt> (periodic_motion.hpp) [length/time].
  double drift_velocity(const NodalMotion& motion, const std::vector<CollinearMobility>& mobilities) const {
    const Vector3d at_rest = towing_forces(mobility_({rest_[0], rest_[1], rest_[2]}).value);
    const NodalMotion rate = beads_ * rates(motion);
    double sum = 0;
    for (int n = 0; n < nodes_; ++n) {
      const Vector3d change = towing_forces(mobilities[n].value) - at_rest;
      sum -= change.dot(rate.col(n));
    }
    return omega_ * sum / nodes_;
  }

 private:
  /// Residuals of the three equations of motion of the beads at one node (time within the period).
  /// Derivatives of the residuals with respect to the motion (changes of the arms and displacement of bead 2)
  /// and to its rate of change. The derivatives with respect to the motion omit terms that vanish with the
  /// residual.
  struct NodeEquations {
    Vector3d residual;
    Matrix3d by_rate, by_motion;
  };

  NodeEquations equations(const NodalMotion& motion, const NodalMotion& rate, double velocity,
                          const Eigen::Vector2d& driving, int node) const {
    const CollinearMobility mu = mobility_(places(motion, node));
    const Eigen::Matrix<double, 2, 3> D = arm_rates();
    const Eigen::Matrix2d impedance = omega_ * (D * mu.value * D.transpose()).inverse();
    const Vector3d w = towing_forces(mu.value);
    const Eigen::Vector2d q(motion(0, node), motion(2, node)), dq(rate(0, node), rate(2, node));
    const Eigen::Vector2d tension = driving - stiffness_.cwiseProduct(q) - damping_.cwiseProduct(dq);
    const Eigen::Matrix2d scale = row_scale_.asDiagonal();

    NodeEquations node_equations{
        .residual = Vector3d::Zero(), .by_rate = Matrix3d::Zero(), .by_motion = Matrix3d::Zero()};
    node_equations.residual << scale * (impedance * dq - tension), w.dot(beads_ * rate.col(node)) + velocity;
    const Eigen::Matrix2d by_arm_rate = scale * (impedance + Eigen::Matrix2d(damping_.asDiagonal()));
    for (int arm = 0; arm < 2; ++arm) {
      node_equations.by_rate.col(2 * arm).head<2>() = by_arm_rate.col(arm);
      node_equations.by_motion(arm, 2 * arm) = row_scale_[arm] * stiffness_[arm];
    }
    node_equations.by_rate.row(2) = w.transpose() * beads_;

    Matrix3d drift_by_place;
    for (int k = 0; k < 3; ++k) drift_by_place.col(k) = mu.slope[k] * (D.transpose() * tension) / omega_;
    Matrix3d equations_of_drift;
    equations_of_drift << scale * impedance * D, w.transpose();
    node_equations.by_motion -= equations_of_drift * drift_by_place * beads_;
    return node_equations;
  }

  /// Returns g, the tensions of the two arms by the driving, at a node.
  Eigen::Vector2d driving_tension(int node) const {
    return (driving_ * std::polar(1.0, node_phase(node, nodes_))).real();
  }

  const MobilityFunction& mobility_;
  Vector3d rest_;
  int nodes_;
  double omega_;
  MatrixXd derivative_;
  Matrix3d beads_ = beads_from_motion();
  Eigen::Vector2d stiffness_, damping_;  ///< k_i, omega c_i [mass/time^2]
  Eigen::Vector2cd driving_;
  Eigen::Vector2d row_scale_;  ///< scales the equations of both arms to the same magnitude
};

/// Unknowns of the equations of motion, which Newton's method determines.
struct State {
  NodalMotion motion;
  double velocity = 0;  ///< V/omega [length]
};

double smallest_gap_of(const CollinearSwimmer& swimmer, const HarmonicBalance& balance,
                       const NodalMotion& motion) {
  double smallest = smallest_gap(swimmer, balance.places(motion, 0));
  for (int n = 1; n < motion.cols(); ++n)
    smallest = std::min(smallest, smallest_gap(swimmer, balance.places(motion, n)));
  return smallest;
}

/// Solves the equations of motion by Newton's method with the initial guess `state`, with the driving forces
/// multiplied by `driving`. A step after which a gap would be below `min_gap` [length] is halved until no gap
/// is. Returns nullopt if the method does not converge.
std::optional<State> solve_newton(const CollinearSwimmer& swimmer, const HarmonicBalance& balance,
                                  State state, double driving, double min_gap) {
  constexpr int max_steps = 40, max_halvings = 3;  // shorter steps end near contact
  constexpr double last_step = 1e-8;  // relative to the motion; then the error is its square
  const int nodes = static_cast<int>(state.motion.cols());
  if (!(smallest_gap_of(swimmer, balance, state.motion) > min_gap)) state.motion.setZero();
  for (int step = 0; step < max_steps; ++step) {
    const VectorXd full = balance.newton_step(state.motion, state.velocity, driving);
    if (!full.allFinite()) return std::nullopt;
    const Eigen::Map<const NodalMotion> change(full.data(), 3, nodes);
    double part = 1;
    for (int halving = 0;; ++halving, part /= 2) {
      if (halving == max_halvings) return std::nullopt;
      const NodalMotion trial = state.motion - part * change;
      if (smallest_gap_of(swimmer, balance, trial) > min_gap) break;
    }
    state.motion -= part * change;
    state.velocity -= part * full[full.size() - 1];
    const double size = state.motion.cwiseAbs().maxCoeff();
    if (part == 1 && change.cwiseAbs().maxCoeff() <= last_step * size) return state;
  }
  return std::nullopt;
}

/// Returns the motion to first order in the driving amplitude, the initial guess of Newton's method.
State first_order_state(const CollinearSwimmer& swimmer, const LinePositions& rest,
                        const MobilityFunction& mobility, int nodes) {
  const LinearResponse response = linear_response(swimmer, mobility(rest).value);
  State state{.motion = NodalMotion(3, nodes)};
  for (int n = 0; n < nodes; ++n) {
    const Vector3d beads = (response.displacement * std::polar(1.0, node_phase(n, nodes))).real();
    state.motion.col(n) = motion_of_beads(beads);
  }
  return state;
}

std::string contact_message(double reached, double min_gap_over_radius) {
  return fmt::format(
      "no periodic motion without contact was found: if the driving amplitude exceeds about {:.2g} times the "
      "given amplitude, a gap between beads becomes smaller than {:.3g} bead radii or a soft spring "
      "collapses; reduce {}, or increase {}, {} or {}",
      reached, min_gap_over_radius, Setting::amplitude, Setting::stiffness, Setting::damping, Setting::arm);
}

/// Returns the motion under the full driving, with the initial guess `start`. If Newton's method does not
/// converge, the driving is increased from zero in smaller steps (continuation). Throws InputError if such a
/// step becomes smaller than 1/64 of the driving.
State continue_to_full_driving(const CollinearSwimmer& swimmer, const HarmonicBalance& balance,
                               const State& start, double min_gap) {
  constexpr double smallest_step = 1.0 / 64;
  State reached{.motion = NodalMotion::Zero(3, start.motion.cols())};
  double driving = 0, step = 1;
  while (driving < 1) {
    const double next = std::min(driving + step, 1.0);
    State guess = reached;
    if (driving == 0) guess.motion = next * start.motion;
    if (auto found = solve_newton(swimmer, balance, guess, next, min_gap)) {
      reached = *found;
      driving = next;
    } else if ((step /= 2) < smallest_step) {
      throw InputError("stroke",
                       contact_message(driving, min_gap / *std::ranges::min_element(swimmer.radius)));
    }
  }
  return reached;
}

PeriodicMotion motion_result(const CollinearSwimmer& swimmer, const HarmonicBalance& balance,
                             const NodalMotion& nodal) {
  const std::vector<CollinearMobility> mobilities = balance.mobilities(nodal);
  return {.velocity = balance.drift_velocity(nodal, mobilities),
          .stroke = stroke_of(
              Eigen::Vector2cd(harmonic_amplitude(nodal.row(0), 1), harmonic_amplitude(nodal.row(2), 1))),
          .arm_changes = {nodal.row(0).mean(), nodal.row(2).mean()},
          .smallest_gap = smallest_gap_of(swimmer, balance, nodal),
          .dipole = dipole_of_line(balance.mean_dipole(nodal, mobilities)),
          .samples = static_cast<int>(nodal.cols())};
}

}  // namespace

double smallest_gap(const CollinearSwimmer& swimmer, const LinePositions& x) {
  return std::min(x[1] - x[0] - swimmer.radius[0] - swimmer.radius[1],
                  x[2] - x[1] - swimmer.radius[1] - swimmer.radius[2]);
}

PeriodicMotion periodic_motion(const CollinearSwimmer& swimmer, const LinePositions& rest,
                               const MobilityFunction& mobility, double min_gap) {
  constexpr int min_nodes = 25, max_nodes = 401;
  constexpr double resolved = 1e-12;  // amplitude of the highest harmonics, divided by the largest motion
  State state = first_order_state(swimmer, rest, mobility, min_nodes);
  const bool driven = state.motion.cwiseAbs().maxCoeff() > 0;
  for (int nodes = min_nodes; nodes <= max_nodes; nodes = 2 * nodes - 1) {
    const HarmonicBalance balance(swimmer, rest, mobility, nodes);
    if (!driven) return motion_result(swimmer, balance, state.motion);
    if (nodes > min_nodes) state.motion = interpolated(state.motion, nodes);
    state = continue_to_full_driving(swimmer, balance, state, min_gap);
    if (unresolved_part(state.motion) < resolved) return motion_result(swimmer, balance, state.motion);
  }
  throw InputError("stroke",
                   "the periodic motion of the swimmer has more than {} harmonics, too many to compute; "
                   "reduce {}, so that the gaps between beads stay larger",
                   max_nodes / 2, Setting::amplitude);
}

}  // namespace beadswim
