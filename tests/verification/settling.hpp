#pragma once

#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "beadswim/core/vec3.hpp"
#include "beadswim/lattice/trt.hpp"

// Detects when a flow has become steady, and extrapolates its limit.

namespace beadswim::verification {

/// Returns the time in which the slowest mode of flow in a periodic box decays, L^2/(4 pi^2 nu) [step].
inline double diffusion_time(const Index3& cells, double relaxation_time) {
  const double longest = cells.maxCoeff();
  return longest * longest / (4 * std::numbers::pi * std::numbers::pi * lattice_viscosity(relaxation_time));
}

/// Returns the number of steps between two checks of whether a flow has become steady.
inline int settling_interval(const Index3& cells, double relaxation_time) {
  return static_cast<int>(std::ceil(0.25 * diffusion_time(cells, relaxation_time))) + 8;
}

/// Returns the limit of a sequence that approaches its limit exponentially and is sampled at equal intervals
/// (Aitken): x - (x - x')^2/(x - 2 x' + x''). x: last value; x', x'': the two values before.
inline double aitken_limit(double x, double x1, double x2) {
  const double curvature = x - 2 * x1 + x2, change = x - x1;
  return curvature == 0 ? x : x - change * change / curvature;
}

/// Several numbers that approach their limits together.
class Settling {
 public:
  /// `tolerance`: relative to the largest of the numbers.
  explicit Settling(double tolerance) : tolerance_(tolerance) {}

  void add(const std::vector<double>& values) {
    history_.push_back(values);
    if (history_.size() < 3) return;
    const auto last = history_.rbegin();
    std::vector<double> limits;
    double largest = 0, limit_change = 0, change = 0;
    for (std::size_t k = 0; k < values.size(); ++k) {
      const double limit = aitken_limit(last[0][k], last[1][k], last[2][k]);
      largest = std::max(largest, std::abs(values[k]));
      change = std::max(change, std::abs(last[0][k] - last[1][k]));
      if (!limits_.empty()) limit_change = std::max(limit_change, std::abs(limit - limits_[k]));
      limits.push_back(limit);
    }
    // Far from the limit the sequence is no single exponential yet, and two limits may agree by chance; close
    // to it roundoff spoils the formula.
    constexpr double near = 3e-4;
    agreements_ = !limits_.empty() && limit_change < tolerance_ * largest ? agreements_ + 1 : 0;
    settled_ = change < near * largest && agreements_ >= 2;
    if (change < 0.1 * tolerance_ * largest) {
      settled_ = true;
      limits = values;
    }
    limits_ = limits;
  }

  bool settled() const { return settled_; }
  const std::vector<double>& limits() const { return limits_; }

 private:
  double tolerance_;
  bool settled_ = false;
  int agreements_ = 0;  ///< number of successive limits that agree
  std::vector<std::vector<double>> history_;
  std::vector<double> limits_;
};

}  // namespace beadswim::verification
