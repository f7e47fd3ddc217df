#include "shape_cycle.hpp"

#include <Eigen/LU>
#include <array>
#include <cmath>
#include <limits>

#include "shape_flow.hpp"

namespace beadswim {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int stages = 3;
const double root = std::sqrt(6.0);
// clang-format off
/// Nodes c_i and weights a_ij of Radau IIA.
const std::array<double, stages> node{(4 - root) / 10, (4 + root) / 10, 1};
const Eigen::Matrix3d weight{
    {( 88 -  7 * root) /  360, (296 - 169 * root) / 1800, (-2 + 3 * root) / 225},
    {(296 + 169 * root) / 1800, ( 88 +   7 * root) /  360, (-2 - 3 * root) / 225},
    {( 16 -      root) /   36, ( 16 +       root) /   36,  1.0 / 9}};
// clang-format on

/// The equations of one step h from time t. The displacements z_i at the stages satisfy
///
///   z_i = h sum_j a_ij v(x + z_j, t + c_j h)
class StepEquations {
 public:
  StepEquations(const ShapeFlow& flow, const BeadVectors& x, double t, double h)
      : flow_(flow), x_(x), t_(t), h_(h), size_(x.size()) {}

  VectorXd residual(const VectorXd& z) const {
    VectorXd residual = z;
    for (int j = 0; j < stages; ++j) {
      const VectorXd v = flow_.velocities(beads(z, j), time(j));
      for (int i = 0; i < stages; ++i) residual.segment(i * size_, size_) -= h_ * weight(i, j) * v;
    }
    return residual;
  }

  /// Returns the derivative of residual() by z, without the change of the mobility.
  MatrixXd derivative(const VectorXd& z) const {
    MatrixXd derivative = MatrixXd::Identity(stages * size_, stages * size_);
    for (int j = 0; j < stages; ++j) {
      const MatrixXd relaxation = flow_.relaxation(beads(z, j), time(j));
      for (int i = 0; i < stages; ++i)
        derivative.block(i * size_, j * size_, size_, size_) -= h_ * weight(i, j) * relaxation;
    }
    return derivative;
  }

  BeadVectors end(const VectorXd& z) const { return beads(z, stages - 1); }

 private:
  BeadVectors beads(const VectorXd& z, int stage) const {
    return x_ + as_beads(z.segment(stage * size_, size_));
  }
  double time(int stage) const { return t_ + node[stage] * h_; }

  const ShapeFlow& flow_;
  const BeadVectors& x_;
  double t_, h_;
  Eigen::Index size_;
};

/// Returns the beads after a step, by Newton's method, or nothing if it does not converge. The derivative is
/// evaluated again only where the iteration converges slowly. Adds an upper bound of the remaining error.
std::optional<BeadVectors> step(const ShapeFlow& flow, const BeadVectors& x, double t, double h, double size,
                                double& error) {
  const StepEquations equations(flow, x, t, h);
  VectorXd z = VectorXd::Zero(stages * x.size());
  Eigen::PartialPivLU<MatrixXd> newton(equations.derivative(z));
  constexpr int max_iterations = 60;
  // Changes of z, divided by the size of the swimmer: at the end, and where roundoff of stiff springs may end
  // the iteration.
  constexpr double converged = 1e-14, roundoff = 1e-10;
  constexpr double fast = 0.6;  // ratio of successive changes
  double last = std::numeric_limits<double>::infinity();
  for (int iteration = 0; iteration < max_iterations; ++iteration) {
    const VectorXd change = newton.solve(equations.residual(z));
    z -= change;
    const double largest = change.cwiseAbs().maxCoeff();
    if (!std::isfinite(largest)) break;
    const bool is_slow = largest > fast * last;
    if (largest <= converged * size || (largest <= roundoff * size && is_slow)) {
      error += 2 * largest + std::numeric_limits<double>::epsilon() * size;
      return equations.end(z);
    }
    if (is_slow) newton.compute(equations.derivative(z));
    last = largest;
  }
  return std::nullopt;
}

}  // namespace

std::optional<ShapeCycle> integrate_cycle(const ShapedSwimmer& swimmer, const ShapeMobility& mobility,
                                          const BeadVectors& start, int steps) {
  const ShapeFlow flow(swimmer, mobility);
  const double h = swimmer.type.driving.period / steps;
  const double size = start.cwiseAbs().maxCoeff() + swimmer.type.beads[0].radius;
  ShapeCycle cycle;
  BeadVectors x = start;
  for (int s = 0;; ++s) {
    flow.require_positive_mobility(x);
    cycle.beads.push_back(x);
    cycle.velocities.push_back(as_beads(flow.velocities(x, s * h)));
    if (s == steps) return cycle;
    const std::optional<BeadVectors> next = step(flow, x, s * h, h, size, cycle.error);
    if (!next) return std::nullopt;
    x = *next;
  }
}

}  // namespace beadswim
