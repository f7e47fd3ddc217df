#include "beadswim/compare/stroke_fit.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <numbers>

#include "beadswim/core/error.hpp"

namespace beadswim {
namespace {

/// Relative threshold for the rank of the design matrix. Below this threshold, two columns are nearly
/// linearly dependent, and the samples do not determine amplitude and phase.
constexpr double rank_threshold = 1e-10;

/// Returns the design matrix with columns 1, cos(w t), sin(w t) of the linear model mean + a cos(w t) + b
/// sin(w t).
Eigen::MatrixX3d harmonic_design(std::span<const double> times, double angular_frequency) {
  const auto n = static_cast<Eigen::Index>(times.size());
  const auto angle = angular_frequency * Eigen::Map<const Eigen::ArrayXd>(times.data(), n);
  Eigen::MatrixX3d design(n, 3);
  design.col(0).setOnes();
  design.col(1) = angle.cos();
  design.col(2) = angle.sin();
  return design;
}

/// Converts a cos x + b sin x to d cos(x + delta): a = d cos(delta) and b = -d sin(delta).
StrokeFit from_linear_form(double mean, double a, double b) {
  const double amplitude = std::hypot(a, b);
  if (amplitude == 0) return {.mean = mean, .amplitude = 0, .phase = 0};
  const double phase = std::atan2(-b, a);
  return {
      .mean = mean, .amplitude = amplitude, .phase = phase > -std::numbers::pi ? phase : std::numbers::pi};
}

}  // namespace

StrokeFit fit_stroke(std::span<const double> times, std::span<const double> lengths,
                     double angular_frequency) {
  if (times.size() != lengths.size() || times.size() < 3) {
    throw InputError(
        "stroke fit",
        "there are {} times and {} arm lengths; the fit needs one arm length per time, and at least 3 times",
        times.size(), lengths.size());
  }
  Eigen::ColPivHouseholderQR<Eigen::MatrixX3d> qr(harmonic_design(times, angular_frequency));
  qr.setThreshold(rank_threshold);
  if (qr.rank() < 3) {
    throw InputError("stroke fit",
                     "the times of the samples do not determine mean, amplitude and phase of the arm length; "
                     "sample the cycle at three phases or more that are not half a period apart");
  }
  const auto n = static_cast<Eigen::Index>(lengths.size());
  const Eigen::Vector3d solution = qr.solve(Eigen::Map<const Eigen::VectorXd>(lengths.data(), n));
  return from_linear_form(solution[0], solution[1], solution[2]);
}

}  // namespace beadswim
